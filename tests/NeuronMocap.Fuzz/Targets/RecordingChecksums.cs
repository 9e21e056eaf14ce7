using System.Buffers.Binary;
using NeuronMocap.Recording;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>Corrects the checksums of a recording. Otherwise every changed file would fail at the first checksum.</summary>
internal static class RecordingChecksums
{
    /// <summary>Writes the checksums of the head and the blocks to match their current content.</summary>
    public static void Mend(Span<byte> file)
    {
        if (file.Length < RecordingLayout.FileHeaderSize)
            return;

        const int HeadChecksum = RecordingLayout.FileHeaderSize - sizeof(uint);
        uint seed = Crc32C.Append(0, file[..HeadChecksum]);
        BinaryPrimitives.WriteUInt32LittleEndian(file[HeadChecksum..], seed);
        int place = RecordingLayout.FileHeaderSize;
        int found;
        while ((found = file[place..].IndexOf(BlockHeader.Marker)) >= 0 && file.Length - place - found >= RecordingLayout.BlockHeaderSize)
        {
            place += found;
            Span<byte> header = file[place..];
            int length = BinaryPrimitives.ReadInt32LittleEndian(header[12..]);
            int room = header.Length - RecordingLayout.BlockHeaderSize;
            if (length >= 0 && length <= room)
                BinaryPrimitives.WriteUInt32LittleEndian(header[24..], Crc32C.Append(0, header.Slice(RecordingLayout.BlockHeaderSize, length)));

            BinaryPrimitives.WriteUInt32LittleEndian(header[28..], Crc32C.Append(seed, header[..28]));
            place += RecordingLayout.BlockHeaderSize;
        }
    }
}
