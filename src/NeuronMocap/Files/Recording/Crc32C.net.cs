using System.Buffers.Binary;
using System.Numerics;

namespace NeuronMocap.Recording;

// CRC-32C (Castagnoli, reflected 0x82F63B78), for which processors have an instruction.
internal static class Crc32C
{
    // The value of no bytes is 0; the value of a text is that of its second part, continued from that of its first.
    public static uint Append(uint crc, ReadOnlySpan<byte> bytes)
    {
        crc = ~crc;
        while (bytes.Length >= sizeof(ulong))
        {
            crc = BitOperations.Crc32C(crc, BinaryPrimitives.ReadUInt64LittleEndian(bytes));
            bytes = bytes[sizeof(ulong)..];
        }

        foreach (byte value in bytes)
            crc = BitOperations.Crc32C(crc, value);

        return ~crc;
    }
}
