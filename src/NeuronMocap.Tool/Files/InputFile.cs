using System.Runtime.InteropServices;

namespace NeuronMocap.Tool.Files;

/// <summary>Checks all files that a command line names. Only regular files are read.</summary>
/// <remarks>A pipe or a terminal blocks while nothing is written to it, and a device such as /dev/zero never ends.</remarks>
internal static class InputFile
{
    private const int CurrentFolder = -100; // AT_FDCWD
    private const uint TypeOnly = 1; // STATX_TYPE
    private const int StatxSize = 256;
    private const int StatxMode = 28;
    private const int AppleStatSize = 256;
    private const int AppleStatMode = 4;
    private const int TypeMask = 0xF000;

    /// <summary>Checks a file before it is opened.</summary>
    /// <param name="path">The name on the command line.</param>
    /// <exception cref="IOException">The file is not a regular file, or it is empty. The message says what it is.</exception>
    public static void Require(string path)
    {
        if (string.IsNullOrWhiteSpace(path))
            throw new IOException("The name of the file is empty.");
        if (FindOddKind(path) is { } kind)
            throw new IOException($"'{path}' is {kind}; only regular files are read.");

        // Files of /proc have no size, and some of them block.
        var file = new FileInfo(path);
        if (file is { Exists: true, Length: 0 })
            throw new IOException($"'{path}' is empty.");
    }

    /// <summary>Describes a file that is not a regular file. Null for a regular file, and for a file that does not exist.</summary>
    public static string? FindOddKind(string path)
    {
        if (Directory.Exists(path))
            return "a folder";
        if (OperatingSystem.IsWindows())
            return path.StartsWith(@"\\.\", StringComparison.Ordinal) ? "a device" : null;

        try
        {
            return Describe(OperatingSystem.IsMacOS() ? ReadAppleMode(path) : ReadMode(path));
        }
        catch (Exception exception) when (exception is EntryPointNotFoundException or DllNotFoundException)
        {
            // The C library is too old. Opening the file will show the problem.
            return null;
        }
    }

    private static string? Describe(int mode) => (mode & TypeMask) switch
    {
        0x1000 => "a pipe (FIFO)",
        0x2000 => "a terminal or another character device",
        0x4000 => "a folder",
        0x6000 => "a block device",
        0xC000 => "a socket",
        _ => null,
    };

    private static int ReadMode(string path)
    {
        byte[] status = new byte[StatxSize];
        return Statx(CurrentFolder, path, 0, TypeOnly, status) == 0 ? BitConverter.ToUInt16(status, StatxMode) : 0;
    }

    private static int ReadAppleMode(string path)
    {
        byte[] status = new byte[AppleStatSize];
        int result = RuntimeInformation.ProcessArchitecture == Architecture.X64 ? AppleStat64(path, status) : AppleStat(path, status);
        return result == 0 ? BitConverter.ToUInt16(status, AppleStatMode) : 0;
    }

    [DllImport("libc", EntryPoint = "statx")]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static extern int Statx(int folder, [MarshalAs(UnmanagedType.LPUTF8Str)] string path, int flags, uint mask, [Out] byte[] status);

    [DllImport("libc", EntryPoint = "stat")]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static extern int AppleStat([MarshalAs(UnmanagedType.LPUTF8Str)] string path, [Out] byte[] status);

    [DllImport("libc", EntryPoint = "stat$INODE64")]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static extern int AppleStat64([MarshalAs(UnmanagedType.LPUTF8Str)] string path, [Out] byte[] status);
}
