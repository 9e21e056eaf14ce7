using NeuronMocap.Files;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Gltf;

// Holds the keys until the file is written: a GLB file begins with the numbers of keys, and has all keys of a bone in one place. Small animations
// stay in memory, large ones are in a temporary file.
internal sealed class KeySpool(long limit = KeySpool.LargestFile, int memory = KeySpool.DefaultMemory, Func<Stream>? createFile = null) : IDisposable
{
    // The length of a GLB file is a 32-bit number. Some MB are left for the JSON text.
    private const long LargestFile = uint.MaxValue - (32L << 20);
    private const int DefaultMemory = 32 << 20;

    // A frame of 59 rotations and 59 positions, and the time of each.
    private const int LargestFrame = BoneHierarchy.BoneCount * 36;
    private const int FileBuffer = 1 << 16;

    private Stream _stream = new MemoryStream();

    // Size of everything that the file may hold, in bytes.
    public long Promised { get; set; }

    public bool IsFile => _stream is not MemoryStream;

    public void RequireRoom()
    {
        if (Promised + LargestFrame <= limit)
            return;

        throw new NeuronException(
            "The animation does not fit into a GLB file, which has at most 4 GiB: about ten hours at 120 Hz. Write a part of it, a lower rate, or fewer keys.");
    }

    // Returns the place of the bytes.
    public long Append(byte[] bytes, int count)
    {
        try
        {
            if (!IsFile && _stream.Length + count > memory)
                MoveToFile();

            long place = _stream.Seek(0, SeekOrigin.End);
            _stream.Write(bytes, 0, count);
            return place;
        }
        catch (Exception exception) when (IsOfDisk(exception))
        {
            throw new IOException(TemporaryFolderFault.Describe(), exception);
        }
    }

    public void Read(long place, byte[] bytes, int count)
    {
        try
        {
            _stream.Position = place;
            for (int done = 0; done < count;)
            {
                int read = _stream.Read(bytes, done, count - done);
                if (read == 0)
                    throw new EndOfStreamException("The temporary file of the keys was shortened.");

                done += read;
            }
        }
        catch (Exception exception) when (IsOfDisk(exception))
        {
            throw new IOException(TemporaryFolderFault.Describe(), exception);
        }
    }

    public void Dispose() => Discard(_stream);

    // The keys stay in memory if the file cannot hold them.
    private void MoveToFile()
    {
        Stream file = createFile is null ? CreateFile() : createFile();
        try
        {
            _stream.Position = 0;
            _stream.CopyTo(file);
        }
        catch
        {
            Discard(file);
            throw;
        }

        _stream.Dispose();
        _stream = file;
    }

    // The system creates the file so that no other user can read it.
    private static FileStream CreateFile() =>
        new(Path.GetTempFileName(), FileMode.Open, FileAccess.ReadWrite, FileShare.None, FileBuffer, FileOptions.DeleteOnClose);

    // On a full disk, closing fails to write the rest of the buffer, which nobody needs. The file is deleted nevertheless.
    private static void Discard(Stream stream)
    {
        try
        {
            stream.Dispose();
        }
        catch (Exception exception) when (IsOfDisk(exception))
        {
        }
    }

    // A file that is too large for its disk is an argument out of range.
    private static bool IsOfDisk(Exception exception) =>
        exception is (IOException and not EndOfStreamException) or UnauthorizedAccessException or ArgumentOutOfRangeException;
}
