using System.Runtime.InteropServices;
using Microsoft.Win32.SafeHandles;

namespace NeuronMocap.Files;

// Ensures that a file has only one writer at a time, in this process and in others. The name or link that opened the file does not matter.
//
// Windows ensures this itself (FileShare.Read). On other systems, .NET locks whole files, including those of readers, and allows any number of
// writers to share a file. Linux has locks that belong to an open file and do not affect readers. The writer locks one byte far beyond the end
// until the file is closed or the process ends. On other systems, the file is opened briefly in a way that fails while another .NET program has it
// open, even for reading.
internal static class FileWriterLock
{
    // F_OFD_SETLK and the errors that report that the lock is already held.
    private const int SetLock = 37;
    private const int TryAgain = 11;
    private const int AccessDenied = 13;

    private const short WriteLock = 1;
    private const long FarBehindTheEnd = long.MaxValue - 1;

    // The layout of the lock differs on 32-bit systems.
    private static readonly bool HasFileLocks = OperatingSystem.IsLinux() && IntPtr.Size == sizeof(long);

    // Called before the file is opened. Returns true when only TryTake can decide.
    public static bool IsFree(string path) => HasFileLocks || OperatingSystem.IsWindows() || CanBeOpenedAlone(path);

    // The lock lasts as long as the file is open. On a file system without locks, this succeeds.
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

    // The struct flock of 64-bit systems. Process must be 0.
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
