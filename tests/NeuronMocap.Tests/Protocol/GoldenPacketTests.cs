using NeuronMocap.Protocol;

namespace NeuronMocap.Tests.Protocol;

public sealed class GoldenPacketTests
{
    [Theory, EveryGoldenPacket]
    public void The_encoder_writes_the_bytes_of_the_protocol(string name)
    {
        GoldenPacket packet = GoldenPackets.Get(name);
        Assert.Equal(Convert.ToHexString(packet.ByHand), Convert.ToHexString(packet.ByEncoder));
    }

    [Theory, EveryGoldenPacket]
    public void The_scanner_finds_exactly_the_packet(string name)
    {
        GoldenPacket packet = GoldenPackets.Get(name);
        ScanResult result = new PacketScanner().Scan(packet.ByHand);
        Assert.Equal(new ScanResult(ScanStatus.Packet, packet.ByHand.Length, packet.Kind), result);
    }
}
