using Microsoft.Win32.SafeHandles;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>Records of one size in a temporary file: one thread appends, any thread reads at any place. The file goes when it is closed.</summary>
/// <remarks>The memory does not depend on the number of records. The system's file cache makes reading fast.</remarks>
internal sealed class RecordFile : IDisposable
{
    private const int BufferSize = 64 * 1024;

    private readonly SafeFileHandle _file;
    private readonly TakeRoom? _room;
    private readonly byte[] _buffer;
    private int _used;
    private long _written;
    private long _count;
    private volatile bool _isFull;

    /// <summary>Creates an empty file.</summary>
    /// <param name="folder">An existing folder.</param>
    /// <param name="recordSize">Bytes in a record.</param>
    /// <param name="room">The room for the records; null for as much as the disk has.</param>
    /// <exception cref="IOException">The file cannot be created.</exception>
    public RecordFile(string folder, int recordSize, TakeRoom? room = null)
        : this(Create(folder), recordSize, room)
    {
    }

    /// <summary>Uses an empty file that is open for reading and writing.</summary>
    /// <param name="file">The file, which this class closes.</param>
    /// <param name="recordSize">Bytes in a record.</param>
    /// <param name="room">The room for the records; null for as much as the disk has.</param>
    public RecordFile(SafeFileHandle file, int recordSize, TakeRoom? room = null)
    {
        _room = room;
        RecordSize = recordSize;
        _buffer = new byte[Math.Max(recordSize, BufferSize / recordSize * recordSize)];
        _file = file;
    }

    public int RecordSize { get; }

    /// <summary>Number of records that can be read.</summary>
    public long Count => Volatile.Read(ref _count);

    /// <summary>Appends a record, which can be read after the next <see cref="Flush"/>, or once enough others follow.</summary>
    /// <exception cref="IOException">There is no room, or the disk fails. The message is a sentence. Later records do not fit either.</exception>
    public void Append(ReadOnlySpan<byte> record)
    {
        ThrowIfFull();
        record[..RecordSize].CopyTo(_buffer.AsSpan(_used));
        _used += RecordSize;
        if (_used == _buffer.Length)
            Flush();
    }

    /// <summary>Makes all records readable.</summary>
    /// <exception cref="IOException">There is no room, or the disk fails. The message is a sentence.</exception>
    public void Flush()
    {
        if (_used == 0)
            return;

        ThrowIfFull();
        if (_room?.TryTake(_used) == false)
            throw EndFull();

        try
        {
            RandomAccess.Write(_file, _buffer.AsSpan(0, _used), _written);
        }
        catch (Exception exception) when (ScratchFolder.IsOfDisk(exception))
        {
            throw EndFull();
        }

        _written += _used;
        _used = 0;
        Volatile.Write(ref _count, _written / RecordSize);
    }

    /// <summary>Reads records. Thread-safe.</summary>
    /// <param name="first">Number of the first record.</param>
    /// <param name="destination">Room for any number of records.</param>
    /// <returns>The number of records read; fewer than there is room for at the end of the file.</returns>
    /// <exception cref="ObjectDisposedException">The file is closed.</exception>
    public int Read(long first, Span<byte> destination)
    {
        int wanted = (int)Math.Clamp(Count - first, 0, destination.Length / RecordSize);
        Span<byte> rest = destination[..(wanted * RecordSize)];
        long offset = first * RecordSize;
        while (!rest.IsEmpty)
        {
            if (_isFull && offset >= _written)
            {
                _buffer.AsSpan((int)(offset - _written), rest.Length).CopyTo(rest);
                break;
            }

            int here = _isFull ? (int)Math.Min(rest.Length, _written - offset) : rest.Length;
            int count = RandomAccess.Read(_file, rest[..here], offset);
            if (count == 0)
                throw new IOException("A temporary file of the take was cut off.");

            rest = rest[count..];
            offset += count;
        }

        return wanted;
    }

    /// <summary>Checks that more records fit, as far as that is known.</summary>
    /// <exception cref="IOException">They do not. The message is a sentence.</exception>
    public void ThrowIfFull()
    {
        if (_isFull)
            throw NoRoom();
    }

    public void Dispose() => _file.Dispose();

    // What has no room stays in the buffer, which does not change any more.
    private IOException EndFull()
    {
        _isFull = true;
        Volatile.Write(ref _count, (_written + _used) / RecordSize);
        return NoRoom();
    }

    private static IOException NoRoom() => new("The temporary folder of the program has no room for the rest of the take.");

    private static SafeFileHandle Create(string folder) => File.OpenHandle(
        Path.Combine(folder, ScratchFolder.NewName()), FileMode.CreateNew, FileAccess.ReadWrite, FileShare.Read | FileShare.Delete, FileOptions.DeleteOnClose);
}
