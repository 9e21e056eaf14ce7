using System.Buffers.Binary;

namespace NeuronMocap.Recording;

// The first 32 bytes of a block.
internal readonly record struct BlockHeader(BlockKind Kind, BlockEncoding Encoding, uint Sequence, int Length, long Time, uint Checksum)
{
    private const int KindOffset = 4;
    private const int EncodingOffset = 5;
    private const int SequenceOffset = 8;
    private const int LengthOffset = 12;
    private const int TimeOffset = 16;
    private const int ChecksumOffset = 24;
    private const int HeaderChecksumOffset = 28;

    public static ReadOnlySpan<byte> Marker => [0xF7, (byte)'N', (byte)'M', (byte)'B'];

    public void Write(Span<byte> destination, uint seed)
    {
        destination[..RecordingLayout.BlockHeaderSize].Clear();
        Marker.CopyTo(destination);
        destination[KindOffset] = (byte)Kind;
        destination[EncodingOffset] = (byte)Encoding;
        BinaryPrimitives.WriteUInt32LittleEndian(destination[SequenceOffset..], Sequence);
        BinaryPrimitives.WriteInt32LittleEndian(destination[LengthOffset..], Length);
        BinaryPrimitives.WriteInt64LittleEndian(destination[TimeOffset..], Time);
        BinaryPrimitives.WriteUInt32LittleEndian(destination[ChecksumOffset..], Checksum);
        BinaryPrimitives.WriteUInt32LittleEndian(destination[HeaderChecksumOffset..], Crc32C.Append(seed, destination[..HeaderChecksumOffset]));
    }

    public static bool TryRead(ReadOnlySpan<byte> bytes, uint seed, out BlockHeader header)
    {
        header = default;
        if (bytes.Length < RecordingLayout.BlockHeaderSize
            || !bytes.StartsWith(Marker)
            || BinaryPrimitives.ReadUInt32LittleEndian(bytes[HeaderChecksumOffset..]) != Crc32C.Append(seed, bytes[..HeaderChecksumOffset]))
        {
            return false;
        }

        header = new BlockHeader(
            (BlockKind)bytes[KindOffset],
            (BlockEncoding)bytes[EncodingOffset],
            BinaryPrimitives.ReadUInt32LittleEndian(bytes[SequenceOffset..]),
            BinaryPrimitives.ReadInt32LittleEndian(bytes[LengthOffset..]),
            BinaryPrimitives.ReadInt64LittleEndian(bytes[TimeOffset..]),
            BinaryPrimitives.ReadUInt32LittleEndian(bytes[ChecksumOffset..]));
        return header.Length is >= 0 and <= RecordingLayout.MaxPayload && header.Time is >= 0 and <= RecordingLayout.MaxTime;
    }
}
