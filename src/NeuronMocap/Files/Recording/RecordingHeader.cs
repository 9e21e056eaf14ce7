using System.Buffers.Binary;

namespace NeuronMocap.Recording;

// The first 64 bytes of a file. The checksum of this header is the seed of the checksums in block headers. The bytes of a recording may contain a
// block of another recording; the seed ensures that it is never taken for a block of this one.
internal readonly record struct RecordingHeader(DateTimeOffset StartTime, Guid RecordingId, int FileNumber)
{
    public const ushort MajorVersion = 1;
    public const ushort MinorVersion = 0;

    private const int VersionOffset = 8;
    private const int SizeOffset = 12;
    private const int StartOffset = 16;
    private const int IdOffset = 24;
    private const int NumberOffset = 40;
    private const int ChecksumOffset = 60;

    // A byte that is not ASCII, both line ends, and the end-of-text character of old systems. A transfer as text destroys this sequence.
    private static ReadOnlySpan<byte> Magic => [0x89, (byte)'N', (byte)'M', (byte)'R', (byte)'\r', (byte)'\n', 0x1A, (byte)'\n'];

    public const int MagicSize = 8;

    public static bool HasMagic(ReadOnlySpan<byte> start) => start.SequenceEqual(Magic);

    // Returns the checksum.
    public uint Write(Span<byte> destination)
    {
        destination[..RecordingLayout.FileHeaderSize].Clear();
        Magic.CopyTo(destination);
        BinaryPrimitives.WriteUInt16LittleEndian(destination[VersionOffset..], MajorVersion);
        BinaryPrimitives.WriteUInt16LittleEndian(destination[(VersionOffset + 2)..], MinorVersion);
        BinaryPrimitives.WriteInt32LittleEndian(destination[SizeOffset..], RecordingLayout.FileHeaderSize);
        BinaryPrimitives.WriteInt64LittleEndian(destination[StartOffset..], (StartTime - DateTimeOffset.UnixEpoch).Ticks);
        _ = RecordingId.TryWriteBytes(destination[IdOffset..]);
        BinaryPrimitives.WriteInt32LittleEndian(destination[NumberOffset..], FileNumber);
        uint checksum = Crc32C.Append(0, destination[..ChecksumOffset]);
        BinaryPrimitives.WriteUInt32LittleEndian(destination[ChecksumOffset..], checksum);
        return checksum;
    }

    // Throws RecordingFormatException.
    public static RecordingHeader Read(ReadOnlySpan<byte> bytes, out uint checksum)
    {
        ReadOnlySpan<byte> magic = bytes[..Math.Min(bytes.Length, Magic.Length)];
        if (!magic.SequenceEqual(Magic[..magic.Length]))
            throw new RecordingFormatException("This is not a recording: its header is missing.");
        if (bytes.Length < RecordingLayout.FileHeaderSize)
            throw new RecordingFormatException($"The recording is cut off within its header, after {bytes.Length} bytes.");

        checksum = BinaryPrimitives.ReadUInt32LittleEndian(bytes[ChecksumOffset..]);
        if (checksum != Crc32C.Append(0, bytes[..ChecksumOffset]))
            throw new RecordingFormatException("The header of the recording is damaged: its checksum is wrong.");

        int major = BinaryPrimitives.ReadUInt16LittleEndian(bytes[VersionOffset..]);
        if (major != MajorVersion)
            throw new RecordingFormatException($"The recording has version {major} of the format; this program reads version {MajorVersion}.");

        long ticks = BinaryPrimitives.ReadInt64LittleEndian(bytes[StartOffset..]);
        if (ticks < (DateTimeOffset.MinValue - DateTimeOffset.UnixEpoch).Ticks || ticks > (DateTimeOffset.MaxValue - DateTimeOffset.UnixEpoch).Ticks)
            throw new RecordingFormatException("The header of the recording contains an invalid time.");

        return new RecordingHeader(
            DateTimeOffset.UnixEpoch.AddTicks(ticks),
            new Guid(bytes.Slice(IdOffset, NumberOffset - IdOffset).ToArray()),
            BinaryPrimitives.ReadInt32LittleEndian(bytes[NumberOffset..]));
    }
}
