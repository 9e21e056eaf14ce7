using System.Buffers.Binary;

namespace NeuronMocap.Server.Tests;

// Reads as the vendor's b15 and b17 libraries do, by observation (protocol.md section 5). Every receive of up to 40,960 bytes is parsed separately,
// and nothing is joined. After a motion frame, the search continues 64 bytes after its end. Uses nothing of the library.
internal sealed class VendorParser
{
    public const int BufferSize = 40_960;

    private const int HeaderSize = 64;

    public List<(int Avatar, int Frame)> Motion { get; } = [];

    public List<(int Avatar, int Frame)> Calculation { get; } = [];

    public void Parse(ReadOnlySpan<byte> received)
    {
        Assert.True(received.Length <= BufferSize);
        int position = 0;
        while (position + HeaderSize <= received.Length)
        {
            ReadOnlySpan<byte> rest = received[position..];
            bool isMotion = IsHeader(rest, 0xDDFF, 0xEEFF);
            bool isCalculation = IsHeader(rest, 0x88FF, 0x99FF);
            int count = isMotion ? BinaryPrimitives.ReadUInt16LittleEndian(rest[6..]) : isCalculation ? BinaryPrimitives.ReadInt32LittleEndian(rest[6..]) : 0;
            int length = HeaderSize + (count * sizeof(float));
            if (count <= 0 || length > rest.Length)
            {
                position++;
                continue;
            }

            (isMotion ? Motion : Calculation).Add((BinaryPrimitives.ReadInt32LittleEndian(rest[10..]), BinaryPrimitives.ReadInt32LittleEndian(rest[46..])));
            position += isMotion ? length + HeaderSize : length;
        }
    }

    private static bool IsHeader(ReadOnlySpan<byte> bytes, int first, int second) =>
        BinaryPrimitives.ReadUInt16LittleEndian(bytes) == first && BinaryPrimitives.ReadUInt16LittleEndian(bytes[62..]) == second;
}
