namespace NeuronMocap.Tool.View.Web;

/// <summary>A temporary folder that a locked file marks as used. A program deletes the folders of those that were killed and had started a minute before it.</summary>
internal sealed class ScratchLease : IDisposable
{
    private const string Prefix = "neuron-mocap-view-";
    private const string LockName = "used";
    private const string FilesName = "files";
    private const int NameLength = 32;

    // Another program has just made a folder without a lock, or an older version of this program has.
    private static readonly TimeSpan UnlockedAge = TimeSpan.FromDays(1);

    // The program of a newer file may not have locked it yet.
    private static readonly TimeSpan LockAge = TimeSpan.FromMinutes(1);

    private readonly DirectoryInfo _folder;
    private readonly FileStream _lock;

    private ScratchLease(DirectoryInfo folder)
    {
        _folder = folder;
        _lock = new FileStream(System.IO.Path.Combine(folder.FullName, LockName), FileMode.CreateNew, FileAccess.Write, FileShare.None);
        Path = folder.CreateSubdirectory(FilesName).FullName;
    }

    /// <summary>The folder for files.</summary>
    public string Path { get; }

    /// <summary>Makes a new folder, and deletes those that nobody uses any more.</summary>
    public static ScratchLease Take()
    {
        var lease = new ScratchLease(Directory.CreateTempSubdirectory(Prefix));
        try
        {
            foreach (DirectoryInfo other in lease._folder.Parent!.EnumerateDirectories(Prefix + "*"))
                DeleteIfUnused(other);
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            // The user may not list the folder for temporary files.
        }

        return lease;
    }

    public void Dispose()
    {
        _lock.Dispose();
        try
        {
            _folder.Delete(recursive: true);
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            // Something still reads in it. The next program deletes it.
        }
    }

    private static void DeleteIfUnused(DirectoryInfo folder)
    {
        try
        {
            if (IsOwn(folder) && IsUnused(folder))
                Delete(folder);
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            // It is in use, or that of another user.
        }
    }

    // Other users can make folders with any name beside those of this program.
    private static bool IsOwn(DirectoryInfo folder) => !folder.Attributes.HasFlag(FileAttributes.ReparsePoint)
        && (OperatingSystem.IsWindows() || folder.UnixFileMode == (UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute));

    private static bool IsUnused(DirectoryInfo folder)
    {
        var mark = new FileInfo(System.IO.Path.Combine(folder.FullName, LockName));
        if (!mark.Exists)
            return DateTime.UtcNow - folder.LastWriteTimeUtc > UnlockedAge;
        if (DateTime.UtcNow - mark.LastWriteTimeUtc < LockAge)
            return false;

        using FileStream free = mark.Open(FileMode.Open, FileAccess.Write, FileShare.None);
        return true;
    }

    // A folder with anything else in it stays.
    private static void Delete(DirectoryInfo folder)
    {
        var files = new DirectoryInfo(System.IO.Path.Combine(folder.FullName, FilesName));
        foreach (DirectoryInfo place in (DirectoryInfo[])[files, folder])
        {
            if (!place.Exists || place.Attributes.HasFlag(FileAttributes.ReparsePoint))
                continue;

            foreach (FileInfo file in place.EnumerateFiles().Where(static file => IsOwnName(file.Name)))
                file.Delete();

            place.Delete();
        }
    }

    private static bool IsOwnName(string name) =>
        name is LockName || (System.IO.Path.GetFileNameWithoutExtension(name) is { Length: NameLength } plain && plain.All(char.IsAsciiHexDigitLower));
}
