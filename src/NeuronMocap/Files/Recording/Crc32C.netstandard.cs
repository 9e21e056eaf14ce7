using System.Buffers.Binary;

namespace NeuronMocap.Recording;

// CRC-32C (Castagnoli, reflected 0x82F63B78) with tables: eight bytes at a time, one table for each byte.
internal static class Crc32C
{
    private const uint Polynomial = 0x82F6_3B78;
    private const int Tables = 8;
    private const int TableSize = 256;

    private static readonly uint[] Table = CreateTables();

    // The checksum of no bytes is 0. The checksum of two parts is that of the second, continued from that of the first.
    public static uint Append(uint crc, ReadOnlySpan<byte> bytes)
    {
        ReadOnlySpan<uint> table = Table;
        crc = ~crc;
        while (bytes.Length >= sizeof(ulong))
        {
            uint low = BinaryPrimitives.ReadUInt32LittleEndian(bytes) ^ crc;
            uint high = BinaryPrimitives.ReadUInt32LittleEndian(bytes[sizeof(uint)..]);
            crc = table[(7 * TableSize) + (byte)low]
                ^ table[(6 * TableSize) + (byte)(low >> 8)]
                ^ table[(5 * TableSize) + (byte)(low >> 16)]
                ^ table[(4 * TableSize) + (int)(low >> 24)]
                ^ table[(3 * TableSize) + (byte)high]
                ^ table[(2 * TableSize) + (byte)(high >> 8)]
                ^ table[TableSize + (byte)(high >> 16)]
                ^ table[(int)(high >> 24)];
            bytes = bytes[sizeof(ulong)..];
        }

        foreach (byte value in bytes)
            crc = (crc >> 8) ^ table[(byte)(crc ^ value)];

        return ~crc;
    }

    private static uint[] CreateTables()
    {
        uint[] table = new uint[Tables * TableSize];
        for (uint i = 0; i < TableSize; i++)
        {
            uint value = i;
            for (int bit = 0; bit < 8; bit++)
                value = (value & 1) != 0 ? (value >> 1) ^ Polynomial : value >> 1;

            table[i] = value;
        }

        for (int i = TableSize; i < table.Length; i++)
            table[i] = (table[i - TableSize] >> 8) ^ table[(byte)table[i - TableSize]];

        return table;
    }
}
