using System.Text;
using System.Text.RegularExpressions;
using NeuronMocap.Calculation;
using NeuronMocap.Recording;

namespace NeuronMocap.Tool.Files;

/// <summary>The kinds of files.</summary>
internal enum FileKind
{
    Bvh,
    Recording,
    Calculation,

    /// <summary>The raw bytes of a stream, without times.</summary>
    Raw,

    /// <summary>Figures with their animations, which are only written.</summary>
    Glb,

    /// <summary>A table of poses, which is only written.</summary>
    Csv,
}

/// <summary>Determines the kind of a file: for reading by its contents, for writing by its name.</summary>
internal static partial class FileKinds
{
    private const int LookedAt = 64 * 1024;

    /// <summary>The extensions of files that the program reads and writes, in lower case.</summary>
    public static IReadOnlyList<string> Extensions { get; } = [".bvh", ".nmrec", ".calc", ".bin", ".dat", ".glb", ".csv"];

    /// <summary>Determines the kind of a file by its contents.</summary>
    /// <exception cref="UnreadKindException">The program does not read this kind of file.</exception>
    /// <exception cref="IOException">The file does not exist or cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">The user does not have permission to read the file.</exception>
    public static FileKind Recognize(string path)
    {
        InputFile.Require(path);
        byte[] start = ReadStart(path);
        if (RecordingReader.IsRecording(start))
            return FileKind.Recording;
        if (start.AsSpan().StartsWith("glTF"u8))
            throw new UnreadKindException($"'{path}' is a GLB file, which this program writes but does not read.") { IsGlb = true };
        if (IsBvh(start))
            return FileKind.Bvh;
        if (IsText(start) && IsCalculation(path))
            return FileKind.Calculation;

        CheckStream(path);
        return FileKind.Raw;
    }

    /// <summary>Determines the kind of a file to write by its name. Null if the extension is unknown.</summary>
    public static FileKind? OfName(string path) => Path.GetExtension(path).ToLowerInvariant() switch
    {
        ".bvh" => FileKind.Bvh,
        ".nmrec" => FileKind.Recording,
        ".calc" => FileKind.Calculation,
        ".bin" or ".dat" => FileKind.Raw,
        ".glb" => FileKind.Glb,
        ".csv" => FileKind.Csv,
        _ => null,
    };

    private static byte[] ReadStart(string path)
    {
        using var file = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete, bufferSize: 1);
        byte[] start = new byte[LookedAt];
        return start[..file.ReadAtLeast(start, start.Length, throwOnEndOfStream: false)];
    }

    // A damaged file may lack its first line. A file in another encoding than UTF-8 still contains these words. Other texts contain them within sentences.
    private static bool IsBvh(byte[] start)
    {
        // A crash can leave NULs after the end of a file.
        return IsText(start.AsSpan().TrimEnd((byte)0)) && BvhLine().IsMatch(Encoding.Latin1.GetString(start));
    }

    private static bool IsText(ReadOnlySpan<byte> start) => !start.ContainsAnyInRange((byte)0, (byte)8);

    private static bool IsCalculation(string path)
    {
        try
        {
            using CalculationFileReader reader = CalculationFileReader.Open(path);
            return true;
        }
        catch (CalculationFormatException)
        {
            return false;
        }
    }

    // A file without frames may still be recognized, for example as incomplete lines of text.
    private static void CheckStream(string path)
    {
        try
        {
            using RecordedFrameReader reader = RecordedFrameReader.Open(path);
        }
        catch (PlaybackException exception)
        {
            throw new UnreadKindException($"{exception.Message} It is not a BVH file or a calculation export either.", exception);
        }
    }

    [GeneratedRegex(@"\bHIERARCHY\s+ROOT\b|\bCHANNELS\s+[0-9]|(^|[\r\n])[ \t]*(HIERARCHY|MOTION)[ \t]*([\r\n]|$)", RegexOptions.IgnoreCase | RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 60_000)]
    private static partial Regex BvhLine();
}
