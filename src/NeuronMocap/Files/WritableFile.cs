namespace NeuronMocap.Files;

// Opens files to write, each for one writer at a time. Others may read a file while it grows, as one looks at a log.
internal static class WritableFile
{
    // Without a buffer of its own: what is written is the system's, and outlives the process.
    private const int NoBuffer = 1;
    private const FileShare Sharing = FileShare.Read | FileShare.Delete;

    // ERROR_SHARING_VIOLATION.
    private const int SharingViolation = unchecked((int)0x8007_0020);

    // A file that was not there before.
    public static FileStream CreateNew(string path) => Open(path, FileMode.CreateNew);

    // An empty file, whatever was there.
    public static FileStream Create(string path)
    {
        FileStream file = OpenOrCreate(path);
        try
        {
            // A device has no length.
            if (file.CanSeek && file.Length > 0)
                file.SetLength(0);

            return file;
        }
        catch
        {
            file.Dispose();
            throw;
        }
    }

    // A new file, or one that is to be replaced and still holds what it did.
    public static FileStream OpenOrCreate(string path) => Open(path, FileMode.OpenOrCreate);

    private static FileStream Open(string path, FileMode mode)
    {
        ArgumentNullException.ThrowIfNull(path);
        if (!FileWriterLock.IsFree(path))
            throw InUse(path);

        var file = new FileStream(path, mode, FileAccess.Write, Sharing, NoBuffer);
        if (FileWriterLock.TryTake(file))
            return file;

        file.Dispose();
        throw InUse(path);
    }

    private static IOException InUse(string path) => new(
        $"The file '{path}' is being written already, by this program or another one. A file has one writer: choose another name, or end the other one first.",
        SharingViolation);
}
