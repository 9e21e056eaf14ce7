namespace NeuronMocap.Files;

// Opens files for writing, with one writer at a time for each file. Others can read a file while it grows, as with a log file.
internal static class WritableFile
{
    // Without a buffer in the process: written data belongs to the operating system and outlives the process.
    private const int NoBuffer = 1;
    private const FileShare Sharing = FileShare.Read | FileShare.Delete;

    // ERROR_SHARING_VIOLATION.
    private const int SharingViolation = unchecked((int)0x8007_0020);

    // Creates a file that must not exist yet.
    public static FileStream CreateNew(string path) => Open(path, FileMode.CreateNew);

    // Creates an empty file, or empties an existing one.
    public static FileStream Create(string path)
    {
        FileStream file = OpenOrCreate(path);
        try
        {
            // A device does not have a length.
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

    // Creates a file, or opens an existing file to be replaced. The existing content remains.
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
        $"'{path}' is already being written, by this program or another one. Choose another name, or end the other writer first.",
        SharingViolation);
}
