using System.Runtime.InteropServices;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Protocol;

public class StreamFixtureTests
{
    [Theory]
    [EverySplitting("new-180", "new-186", "new-354", "new-360", "old-354", "studio-354", "calculation", "mixed", "zero-count")]
    public void Packets_of_the_test_encoder_are_found_exactly(string name, Splitting splitting)
    {
        StreamFixture fixture = Load(name);
        var verified = new FoundPacket?[fixture.Expected.Count];
        foreach (IEnumerable<ArraySegment<byte>> pieces in Splits.Of(fixture.Bytes, splitting))
        {
            var scan = ScanAll.Of(pieces);
            FoundPacket[] delivered = [.. scan.Packets.Where(CarriesValues)];

            Assert.Equal(fixture.Expected.Count, delivered.Length);
            for (int i = 0; i < delivered.Length; i++)
            {
                if (AreSame(verified[i], delivered[i]))
                    continue;

                AssertEqual(fixture.Expected[i], delivered[i]);
                verified[i] = delivered[i];
            }

            Assert.Equal(fixture.Bytes.Length, scan.Packets.Sum(packet => packet.Bytes.Length) + scan.Skipped + scan.Pending);
        }
    }

    [Theory]
    [EverySplitting]
    public void The_mixed_stream_gives_its_command_and_frames(Splitting splitting)
    {
        StreamFixture fixture = Load("mixed");
        foreach (IEnumerable<ArraySegment<byte>> pieces in Splits.Of(fixture.Bytes, splitting))
        {
            var scan = ScanAll.Of(pieces);
            FoundPacket command = Assert.Single(scan.Packets, packet => packet.Kind == PacketKind.Command);

            Assert.True(DataCommandHeader.TryRead(command.Bytes, out _));
            Assert.Equal(0, scan.Pending);
            Assert.True(scan.Skipped > 0);
        }
    }

    [Theory]
    [EverySplitting]
    public void A_line_of_text_becomes_a_packet(Splitting splitting)
    {
        StreamFixture fixture = Load("text");
        foreach (IEnumerable<ArraySegment<byte>> pieces in Splits.Of(fixture.Bytes, splitting))
        {
            var log = new PacketLog();
            var assembler = new PacketAssembler(new PacketScanner(), log);
            foreach (ArraySegment<byte> piece in pieces)
                assembler.Push(piece, timestamp: 0);

            Assert.Equal(fixture.Expected.Count, log.Packets.Count);
            for (int i = 0; i < log.Packets.Count; i++)
            {
                (ExpectedPacket expected, byte[] image) = (fixture.Expected[i], log.Packets[i].Bytes);
                var header = MotionHeader.Read(image);
                Assert.Equal(
                    (PacketKind.Motion, DataVersion.None, expected.Avatar, expected.Name, (uint?)null, expected.Values.Length),
                    (log.Packets[i].Kind, header.Version, header.AvatarIndex, header.AvatarName.ToString(), header.FrameIndex, header.ValueCount));
                Same.Items(expected.Values, MemoryMarshal.Cast<byte, float>(image.AsSpan(64)).ToArray());
            }

            Assert.Equal((fixture.Bytes.Length, 0, 0), (log.Text, log.Skipped, assembler.PendingBytes));
        }
    }

    [Theory]
    [EverySplitting]
    public void An_Axis_Studio_calculation_packet_is_found(Splitting splitting)
    {
        StreamFixture fixture = Load("studio-calculation");
        foreach (IEnumerable<ArraySegment<byte>> pieces in Splits.Of(fixture.Bytes, splitting))
        {
            var scan = ScanAll.Of(pieces);
            FoundPacket packet = Assert.Single(scan.Packets);

            Assert.Equal(PacketKind.StudioCalculation, packet.Kind);
            Assert.Equal(fixture.Bytes, packet.Bytes);
        }
    }

    /// <summary>Loads a stream. Derived classes load another encoder's streams.</summary>
    internal virtual StreamFixture Load(string name) => StreamFixture.Load(name);

    private static bool AreSame(FoundPacket? one, FoundPacket other) => one?.Kind == other.Kind && one.Bytes.AsSpan().SequenceEqual(other.Bytes);

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
