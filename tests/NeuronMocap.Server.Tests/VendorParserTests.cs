using NeuronMocap.Tests.Network;

namespace NeuronMocap.Server.Tests;

// The parser used by the broadcaster tests loses exactly what the vendor's libraries were observed to lose.
public sealed class VendorParserTests
{
    [Fact]
    public void The_vendor_loses_the_second_of_three_packets_in_one_receive() =>
        AssertParsed([Motion(0), Motion(1), Motion(2)], motion: [0, 2]);

    [Theory]
    [InlineData(63, new[] { 0 })]
    [InlineData(64, new[] { 0, 1 })]
    public void Padding_of_64_bytes_saves_the_second_packet(int filler, int[] motion) =>
        AssertParsed([Motion(0), new byte[filler], Motion(1)], motion);

    [Fact]
    public void Calculation_packets_beside_motion_are_lost() =>
        AssertParsed([Motion(0), Calculation(0), Motion(1), Calculation(1)], motion: [0, 1]);

    [Fact]
    public void Calculation_packets_alone_arrive() => AssertParsed([Calculation(0), Calculation(1), Calculation(2)], motion: [], 0, 1, 2);

    [Fact]
    public void A_packet_that_is_cut_is_lost() => AssertParsed([Motion(0)[..1479]], motion: []);

    [Fact]
    public void Packets_received_one_by_one_arrive()
    {
        var parser = new VendorParser();
        parser.Parse(Motion(0));
        parser.Parse(Calculation(0));
        parser.Parse(Motion(1));
        Assert.Equal([(0, 0), (0, 1)], parser.Motion);
        Assert.Equal([(0, 0)], parser.Calculation);
    }

    private static void AssertParsed(byte[][] packets, int[] motion, params int[] calculation)
    {
        var parser = new VendorParser();
        parser.Parse(packets.SelectMany(packet => packet).ToArray());
        Assert.Equal(motion, parser.Motion.Select(packet => packet.Frame));
        Assert.Equal(calculation, parser.Calculation.Select(packet => packet.Frame));
    }

    private static byte[] Motion(int frame) => TestPackets.Motion(frame);

    private static byte[] Calculation(int frame) => TestPackets.Calculation(frame);
}
