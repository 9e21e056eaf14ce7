using NeuronMocap.Protocol;

namespace NeuronMocap.Tests.Protocol;

public sealed class PacketEncoderTests
{
    [Fact]
    public void A_destination_needs_exactly_the_packets_size()
    {
        float[] values = new float[354];

        Assert.Equal(1480, PacketEncoder.WriteMotion(new byte[1480], new MotionHeader(), values));
        Assert.Throws<ArgumentException>(() => PacketEncoder.WriteMotion(new byte[1479], new MotionHeader(), values));
        Assert.Equal(1480, PacketEncoder.WriteCalculation(new byte[1480], new CalculationHeader(), values));
        Assert.Throws<ArgumentException>(() => PacketEncoder.WriteCalculation(new byte[1479], new CalculationHeader(), values));
    }

    [Fact]
    public void Nothing_is_written_after_the_packet()
    {
        byte[] destination = new byte[100];
        destination.AsSpan().Fill(0xCC);

        int length = PacketEncoder.WriteMotion(destination, new MotionHeader(), [1, 2]);

        Assert.Equal(72, length);
        Assert.All(destination[72..], value => Assert.Equal(0xCC, value));
    }

    [Fact]
    public void The_number_of_values_replaces_the_headers_count()
    {
        byte[] destination = new byte[72];
        PacketEncoder.WriteMotion(destination, new MotionHeader { ValueCount = 354 }, [1, 2]);
        Assert.True(MotionHeader.TryRead(destination, out MotionHeader motion));
        Assert.Equal(2, motion.ValueCount);

        PacketEncoder.WriteCalculation(destination, new CalculationHeader { ValueCount = 946 }, [1, 2]);
        Assert.True(CalculationHeader.TryRead(destination, out CalculationHeader calculation));
        Assert.Equal(2, calculation.ValueCount);
    }

    [Fact]
    public void More_values_than_the_new_layout_counts_are_refused()
    {
        float[] values = new float[65_536];
        byte[] destination = new byte[64 + (4 * values.Length)];

        Assert.Throws<InvalidOperationException>(() => PacketEncoder.WriteMotion(destination, new MotionHeader(), values));
        Assert.Equal(destination.Length, PacketEncoder.WriteMotion(destination, new MotionHeader { Version = DataVersion.Old }, values));
        Assert.Equal(destination.Length - 4, PacketEncoder.WriteMotion(destination, new MotionHeader(), values.AsSpan(1)));
    }

    [Fact]
    public void Every_bit_of_a_value_is_kept()
    {
        uint[] bits = [0x80000000, 0x7FC00001, 0xFFC12345, 0x7F800000, 0xFF800000, 0x00000001, 0x3F800000];
        byte[] packet = new byte[64 + (4 * bits.Length)];
        PacketEncoder.WriteMotion(packet, new MotionHeader(), [.. bits.Select(BitConverter.UInt32BitsToSingle)]);

        for (int i = 0; i < bits.Length; i++)
        {
            byte[] expected = [(byte)bits[i], (byte)(bits[i] >> 8), (byte)(bits[i] >> 16), (byte)(bits[i] >> 24)];
            Assert.Equal(expected, packet[(64 + (4 * i))..(68 + (4 * i))]);
        }
    }
}
