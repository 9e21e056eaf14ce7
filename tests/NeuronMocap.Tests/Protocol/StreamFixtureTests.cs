using NeuronMocap.Protocol;
using NeuronMocap.Tests.Infrastructure;

namespace NeuronMocap.Tests.Protocol;

public sealed class StreamFixtureTests
{
    [Theory]
    [EveryDelivery("new-180", "new-186", "new-354", "new-360", "old-354", "studio-354", "calculation", "mixed", "zero-count")]
    public void A_foreign_encoders_packets_come_out_exactly(string name, Delivery delivery)
    {
        StreamFixture fixture = StreamFixture.Load(name);
        foreach (IEnumerable<ArraySegment<byte>> pieces in Deliveries.Of(fixture.Bytes, delivery))
        {
            var scan = ScanAll.Of(pieces);
            FoundPacket[] delivered = [.. scan.Packets.Where(CarriesValues)];

            Assert.Equal(fixture.Expected.Count, delivered.Length);
            for (int i = 0; i < delivered.Length; i++)
                AssertEqual(fixture.Expected[i], delivered[i]);

            Assert.Equal(fixture.Bytes.Length, scan.Packets.Sum(packet => packet.Bytes.Length) + scan.Skipped + scan.Pending);
        }
    }

    [Theory]
    [EveryDelivery]
    public void In_the_mixed_stream_the_command_is_one_packet_and_all_else_that_is_no_frame_is_skipped(Delivery delivery)
    {
        StreamFixture fixture = StreamFixture.Load("mixed");
        foreach (IEnumerable<ArraySegment<byte>> pieces in Deliveries.Of(fixture.Bytes, delivery))
        {
            var scan = ScanAll.Of(pieces);
            FoundPacket command = Assert.Single(scan.Packets, packet => packet.Kind == PacketKind.Command);

            Assert.True(CommandHeader.TryRead(command.Bytes, out _));
            Assert.Equal(0, scan.Pending);
            Assert.True(scan.Skipped > 0);
        }
    }

    [Theory]
    [EveryDelivery("text", "studio-calculation")]
    public void A_stream_of_another_format_is_skipped_whole(string name, Delivery delivery)
    {
        StreamFixture fixture = StreamFixture.Load(name);
        foreach (IEnumerable<ArraySegment<byte>> pieces in Deliveries.Of(fixture.Bytes, delivery))
        {
            var scan = ScanAll.Of(pieces);

            Assert.Empty(scan.Packets);
            Assert.Equal(fixture.Bytes.Length, scan.Skipped + scan.Pending);
            Assert.InRange(scan.Pending, 0, 63);
        }
    }

    private static bool CarriesValues(FoundPacket packet) => packet.Kind != PacketKind.Command && packet.Bytes.Length > 64;

    private static void AssertEqual(ExpectedPacket expected, FoundPacket found)
    {
        Assert.Equal(expected.Kind, found.Kind);
        if (found.Kind == PacketKind.Motion)
            AssertMotionHeader(expected, found.Bytes);
        else
            AssertCalculationHeader(expected, found.Bytes);

        Assert.Equal(64 + (4 * expected.Values.Length), found.Bytes.Length);
        for (int i = 0; i < expected.Values.Length; i++)
        {
            if (BitConverter.SingleToInt32Bits(expected.Values[i]) != BitConverter.ToInt32(found.Bytes, 64 + (4 * i)))
                Assert.Fail($"Value {i}: expected {expected.Values[i]}, found {BitConverter.ToSingle(found.Bytes, 64 + (4 * i))}.");
        }
    }

    private static void AssertMotionHeader(ExpectedPacket expected, byte[] packet)
    {
        Assert.True(MotionHeader.TryRead(packet, out MotionHeader header));
        Assert.Equal(expected.Layout is "old" ? HeaderLayout.Old : HeaderLayout.New, header.Layout);
        Assert.Equal(expected.Avatar, header.AvatarIndex);
        Assert.Equal(expected.Name, header.AvatarName.ToString());
        Assert.Equal(expected.Index, header.FrameIndex);
        Assert.Equal(expected.Displacement, header.HasDisplacement);
        Assert.Equal(expected.Reference, header.HasReference);
        Assert.Equal(expected.Version, header.Version.ToString());
        Assert.Equal(expected.Values.Length, header.ValueCount);
        uint[] reserved = header.Layout == HeaderLayout.Old
            ? [header.Reserved1, header.Reserved2]
            : [header.Reserved, header.Reserved1, header.Reserved2];
        Assert.Equal(expected.Reserved!, reserved);
    }

    private static void AssertCalculationHeader(ExpectedPacket expected, byte[] packet)
    {
        Assert.True(CalculationHeader.TryRead(packet, out CalculationHeader header));
        Assert.Equal(expected.Avatar, header.AvatarIndex);
        Assert.Equal(expected.Name, header.AvatarName.ToString());
        Assert.Equal(expected.Index, header.FrameIndex);
        Assert.Equal(expected.Values.Length, header.ValueCount);
    }
}
