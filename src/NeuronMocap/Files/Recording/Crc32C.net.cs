using System.Buffers.Binary;
using System.Numerics;

namespace NeuronMocap.Recording;

// CRC-32C (Castagnoli, reflected 0x82F63B78), for which processors have an instruction.
internal static class Crc32C
{
    // The checksum of no bytes is 0. The checksum of two parts is that of the second, continued from that of the first.
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
