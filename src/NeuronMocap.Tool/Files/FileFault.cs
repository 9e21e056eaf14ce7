using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Files;

/// <summary>Describes why a file cannot be read or written. The sentence starts with the name of the file.</summary>
internal static class FileFault
{
    // Error numbers of the system. Linux and macOS share the numbers that have one constant.
    private const int NotThere = 2;
    private const int DeviceMissing = 6;
    private const int NotAllowed = 13;
    private const int IsThere = 17;
    private const int NotAFolder = 20;
    private const int IsFolder = 21;
    private const int Invalid = 22;
    private const int DiskFull = 28;
    private const int ReadOnly = 30;
    private const int NameTooLongLinux = 36;
    private const int NameTooLongMac = 63;
    private const int NotOfSystem = unchecked((int)0x80131620);
    private const int WindowsSharing = unchecked((int)0x80070020);
    private const int WindowsIsThere = unchecked((int)0x80070050);
    private const int WindowsDiskFull = unchecked((int)0x80070070);

    /// <summary>Describes why a file could not be opened for reading.</summary>
    public static string OfReading(Exception exception, string path) => exception switch
    {
        FileNotFoundException or DirectoryNotFoundException when Directory.Exists(path) => IsAFolder(path),
        FileNotFoundException or DirectoryNotFoundException => $"{Quote(path)} does not exist.",
        UnauthorizedAccessException when Directory.Exists(path) => IsAFolder(path),
        UnauthorizedAccessException => $"{Quote(path)} cannot be read: this user has no permission.",
        _ => OfSystem(exception, path) ?? $"{Quote(path)} cannot be read.",
    };

    /// <summary>Describes why a file could not be created or opened for writing.</summary>
    public static string OfWriting(Exception exception, string path) => exception switch
    {
        DirectoryNotFoundException when !Directory.Exists(FolderOf(path)) => $"{Quote(FolderOf(path))}, the folder for {Quote(Path.GetFileName(path))}, does not exist.",
        UnauthorizedAccessException or IOException when Directory.Exists(path) => IsAFolder(path),
        FileNotFoundException or DirectoryNotFoundException => $"{Quote(FolderOf(path))} does not accept new files.",
        UnauthorizedAccessException => $"{Quote(path)} cannot be written: this user has no permission.",
        IOException when IsExisting(exception) && InputFile.FindOddKind(path) is { } kind => $"{Quote(path)} is {kind}; only regular files are written.",
        IOException { HResult: WindowsSharing } => $"{Quote(path)} is already being written, by this program or another one. Choose another name, or end the other writer first.",
        _ => OfSystem(exception, path) ?? $"{Quote(path)} cannot be written.",
    };

    /// <summary>Describes why standard output could not be written.</summary>
    public static string OfStandardOutput(IOException exception) =>
        $"standard output cannot be written{(IsDiskFull(exception) ? ": the disk is full." : ".")}";

    /// <summary>Puts the name of the file before a sentence of the library, unless the sentence has it or is about an option.</summary>
    public static string WithName(string sentence, string path)
    {
        string name = Quote(path);
        return sentence.StartsWith("--", StringComparison.Ordinal) || TerminalText.Clean(sentence).Contains(name, StringComparison.Ordinal)
            ? sentence
            : $"{name}: {sentence}";
    }

    /// <summary>Whether the disk is full.</summary>
    public static bool IsDiskFull(Exception exception) => exception.HResult is DiskFull or WindowsDiskFull;

    /// <summary>Whether a file to be created already exists.</summary>
    public static bool IsExisting(Exception exception) => exception.HResult is IsThere or WindowsIsThere;

    private static string? OfSystem(Exception exception, string path) => exception switch
    {
        NeuronException => OptionNames.Translate(exception.Message),

        // The message comes from this program or the library.
        IOException { HResult: NotOfSystem } when exception.GetType() == typeof(IOException) => exception.Message,
        PathTooLongException => TooLong(),
        ArgumentException when string.IsNullOrWhiteSpace(path) => "The name of the file is empty.",
        ArgumentException fault => path.Contains('\0', StringComparison.Ordinal) ? "The name has a character that is not allowed in file names." : OptionNames.Translate(fault),
        NotSupportedException => $"{Quote(path)} is not a regular file.",
        _ => exception.HResult switch
        {
            NameTooLongLinux or NameTooLongMac => TooLong(),
            IsThere or WindowsIsThere => $"{Quote(path)} already exists.",
            IsFolder => IsAFolder(path),
            NotAFolder => $"{Quote(path)} does not exist: a part of the path is a file, not a folder.",
            NotThere => $"{Quote(path)} does not exist.",
            NotAllowed => $"{Quote(path)} cannot be used: this user has no permission.",
            DiskFull or WindowsDiskFull => $"{Quote(path)}: the disk is full.",
            ReadOnly => $"{Quote(path)} is on a read-only disk.",
            DeviceMissing or Invalid => $"{Quote(path)} is not a regular file.",
            WindowsSharing => $"{Quote(path)} is in use by another program.",
            _ => null,
        },
    };

    private static string IsAFolder(string path) => $"{Quote(path)} is a folder; give the name of a file.";

    private static string TooLong() => "The name is longer than this file system allows.";

    private static string FolderOf(string path)
    {
        try
        {
            return Path.GetDirectoryName(Path.GetFullPath(path)) ?? path;
        }
        catch (IOException)
        {
            // The current folder was deleted.
            return ".";
        }
    }

    private static string Quote(string path) => $"'{TerminalText.Clean(path)}'";
}
