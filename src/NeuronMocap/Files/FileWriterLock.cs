using System.Runtime.InteropServices;
using Microsoft.Win32.SafeHandles;

namespace NeuronMocap.Files;

// Makes sure that a file has one writer, whatever name or link it was opened by, in this process and in others.
//
// Windows does so itself (FileShare.Read). Elsewhere .NET locks whole files, those of readers too, and lets any number of writers share one. Linux has locks
// that belong to an open file and that readers do not meet: one far behind the end is the writer's, until the file is closed or the process ends.
// On other systems the file is opened for an instant in a way that fails while another program of .NET has it open, readers included.
internal static class FileWriterLock
{
    // F_OFD_SETLK and the errors that say that somebody else holds the lock.
    private const int SetLock = 37;
    private const int TryAgain = 11;
    private const int AccessDenied = 13;

    private const short WriteLock = 1;
    private const long FarBehindTheEnd = long.MaxValue - 1;

    // The layout of the lock differs on 32-bit systems.
    private static readonly bool HasFileLocks = OperatingSystem.IsLinux() && IntPtr.Size == sizeof(long);

    // Before the file is opened. True where only TryTake can tell.
    public static bool IsFree(string path) => HasFileLocks || OperatingSystem.IsWindows() || CanBeOpenedAlone(path);

    // For as long as the file is open. A file system without locks is taken as it is.
    public static bool TryTake(FileStream file) => !HasFileLocks || TryLock(file.SafeFileHandle);

    internal static bool CanBeOpenedAlone(string path)
    {
        if (!File.Exists(path))
            return true;

        try
        {
            using var alone = new FileStream(path, FileMode.Open, FileAccess.Write, FileShare.None, bufferSize: 1);
            return true;
        }
        catch (IOException exception) when (exception is not (FileNotFoundException or DirectoryNotFoundException))
        {
            return false;
        }
    }

    private static bool TryLock(SafeFileHandle file)
    {
        var claim = new FileLock { Kind = WriteLock, Start = FarBehindTheEnd, Length = 1 };
        try
        {
            return Control(file, SetLock, ref claim) == 0 || Marshal.GetLastWin32Error() is not (TryAgain or AccessDenied);
        }
        catch (Exception exception) when (exception is DllNotFoundException or EntryPointNotFoundException)
        {
            return true;
        }
    }

    [DllImport("libc", EntryPoint = "fcntl", SetLastError = true)]
    [DefaultDllImportSearchPaths(DllImportSearchPath.System32)]
    private static extern int Control(SafeFileHandle file, int command, ref FileLock claim);

    // struct flock of 64-bit systems. The process must be 0.
    [StructLayout(LayoutKind.Sequential)]
    private struct FileLock
    {
        public short Kind;
        public short Whence;
        public long Start;
        public long Length;
        public int Process;
    }
}
