using System.Text;
using NeuronMocap.Calculation;
using NeuronMocap.Recording;

namespace NeuronMocap.Tool.Files;

/// <summary>What a file is.</summary>
internal enum FileKind
{
    Bvh,
    Recording,
    Calculation,

    /// <summary>The bytes of a stream, without times.</summary>
    Raw,
}

/// <summary>Tells what a file is: of one to read by what is in it, of one to write by its name.</summary>
internal static class FileKinds
{
    private const int LookedAt = 64 * 1024;

    private static readonly string[] BvhWords = ["HIERARCHY", "MOTION", "CHANNELS"];

    /// <summary>Looks into a file.</summary>
    /// <exception cref="NeuronException">It is none of those that can be read.</exception>
    /// <exception cref="IOException">It is not there, or cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">It may not be read.</exception>
    public static FileKind Recognize(string path)
    {
        InputFile.Require(path);
        byte[] start = ReadStart(path);
        if (RecordingReader.IsRecording(start))
            return FileKind.Recording;
        if (IsBvh(start))
            return FileKind.Bvh;
        if (IsText(start) && IsCalculation(path))
            return FileKind.Calculation;

        CheckStream(path);
        return FileKind.Raw;
    }

    /// <summary>What a file is to become; null when its name says nothing that is known.</summary>
    public static FileKind? OfName(string path) => Path.GetExtension(path).ToLowerInvariant() switch
    {
        ".bvh" => FileKind.Bvh,
        ".nmrec" => FileKind.Recording,
        ".calc" => FileKind.Calculation,
        ".bin" or ".dat" => FileKind.Raw,
        _ => null,
    };

    private static byte[] ReadStart(string path)
    {
        using var file = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete, bufferSize: 1);
        byte[] start = new byte[LookedAt];
        return start[..file.ReadAtLeast(start, start.Length, throwOnEndOfStream: false)];
    }

    // A damaged file may lack its first line; one in another encoding than UTF-8 still has these words.
    private static bool IsBvh(byte[] start)
    {
        if (!IsText(start))
            return false;

        string text = Encoding.Latin1.GetString(start);
        return BvhWords.Any(word => text.Contains(word, StringComparison.OrdinalIgnoreCase));
    }

    private static bool IsText(byte[] start) => !start.AsSpan().ContainsAnyInRange((byte)0, (byte)8);

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

    // What no frame is in may still be known, such as lines of text that lack something.
    private static void CheckStream(string path)
    {
        try
        {
            using RecordedFrameReader reader = RecordedFrameReader.Open(path);
        }
        catch (PlaybackException exception)
        {
            throw new NeuronException($"{exception.Message} It is not a BVH file or a calculation export either.", exception);
        }
    }
}
