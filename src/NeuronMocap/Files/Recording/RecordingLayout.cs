namespace NeuronMocap.Recording;

// Sizes of the file format, which docs/reference/recording.md describes. All numbers in it are little endian.
internal static class RecordingLayout
{
    public const int FileHeaderSize = 64;
    public const int BlockHeaderSize = 32;

    // No block is larger, as it lies in the file and unpacked: what a reader has to allocate for a hostile file.
    public const int MaxPayload = 1024 * 1024;

    // A block that has grown to this is written.
    public const int BlockSize = 64 * 1024;

    public const int MaxPiece = 512 * 1024;

    // 3,600 years: sums of two of them never overflow.
    public const long MaxTime = 1L << 60;

    // Connections and senders that are open at a time: what a checkpoint repeats.
    public const int MaxOpen = 1024;

    public const int MaxTextBytes = 255;
}

internal enum BlockKind : byte
{
    Entries = 1,

    // Entries that tell once more what was told before and still holds: reading may begin here.
    Checkpoint = 2,

    // Where the checkpoints are.
    Index = 3,

    // The last block of a file that was closed in an orderly way: where the index is, and sums.
    End = 4,
}

internal enum BlockEncoding : byte
{
    Plain = 0,

    // Four bytes with the length unpacked, then the Deflate stream (RFC 1951).
    Deflate = 1,
}
