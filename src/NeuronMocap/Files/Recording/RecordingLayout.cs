using System.Text;

namespace NeuronMocap.Recording;

// Sizes and limits of the file format, which docs/reference/recording.md describes. All numbers in the file are little endian.
internal static class RecordingLayout
{
    public const int FileHeaderSize = 64;
    public const int BlockHeaderSize = 32;

    // Maximum payload of a block, both as stored and unpacked. It limits the memory that a hostile file can make a reader allocate.
    public const int MaxPayload = 1024 * 1024;

    // A block is written when it reaches this size.
    public const int BlockSize = 64 * 1024;

    public const int MaxPiece = 512 * 1024;

    // 3,600 years. The sum of two such times never overflows.
    public const long MaxTime = 1L << 60;

    // Maximum number of connections and senders that are open at a time. A checkpoint repeats them.
    public const int MaxOpen = 1024;

    public const int MaxTextBytes = 255;

    public static string CutText(string text)
    {
        if (Encoding.UTF8.GetByteCount(text) <= MaxTextBytes)
            return text;

        int length = MaxTextBytes;
        while (Encoding.UTF8.GetByteCount(text.AsSpan(0, Math.Min(length, text.Length))) > MaxTextBytes)
            length--;

        return text[..length];
    }
}

internal enum BlockKind : byte
{
    Entries = 1,

    // Entries that repeat the current metadata, connections and senders. Reading can begin here.
    Checkpoint = 2,

    // The positions of the checkpoints.
    Index = 3,

    // The last block of a file that was closed properly: the position of the index, and totals.
    End = 4,
}

internal enum BlockEncoding : byte
{
    Plain = 0,

    // Four bytes with the unpacked length, then the Deflate stream (RFC 1951).
    Deflate = 1,
}
