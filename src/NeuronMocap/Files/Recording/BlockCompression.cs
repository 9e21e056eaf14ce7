using System.Buffers.Binary;
using System.IO.Compression;

namespace NeuronMocap.Recording;

// Packs a payload as its length and a Deflate stream. A block that would not become smaller stays as it is.
internal sealed class BlockCompression : IDisposable
{
    private readonly MemoryStream _packed = new();

    // The packed payload follows space reserved for a block header. It is in this object's memory and valid until the next call.
    public bool TryPack(ReadOnlySpan<byte> payload, out Span<byte> block)
    {
        Span<byte> length = stackalloc byte[sizeof(int)];
        BinaryPrimitives.WriteInt32LittleEndian(length, payload.Length);
        _packed.SetLength(RecordingLayout.BlockHeaderSize);
        _packed.Position = RecordingLayout.BlockHeaderSize;
        _packed.Write(length);
        using (var deflate = new DeflateStream(_packed, CompressionLevel.Optimal, leaveOpen: true))
            deflate.Write(payload);

        block = _packed.GetBuffer().AsSpan(0, (int)_packed.Length);
        return block.Length < RecordingLayout.BlockHeaderSize + payload.Length;
    }

    public void Dispose() => _packed.Dispose();

    // Returns false if the payload is not a Deflate stream of exactly the declared length.
    public static bool TryUnpack(byte[] packed, int start, int count, ref byte[] buffer, out int length)
    {
        length = 0;
        if (count < sizeof(int))
            return false;

        length = BinaryPrimitives.ReadInt32LittleEndian(packed.AsSpan(start, sizeof(int)));
        if (length is < 0 or > RecordingLayout.MaxPayload)
            return false;
        if (buffer.Length < length)
            buffer = new byte[length];

        try
        {
            using var deflate = new DeflateStream(new MemoryStream(packed, start + sizeof(int), count - sizeof(int)), CompressionMode.Decompress);
            return StreamReads.Fill(deflate, buffer.AsSpan(0, length)) == length && deflate.ReadByte() < 0;
        }
        catch (InvalidDataException)
        {
            return false;
        }
    }
}
