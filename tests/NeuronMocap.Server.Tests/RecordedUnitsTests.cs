using System.Text;
using NeuronMocap.Recording;
using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Playback;

namespace NeuronMocap.Server.Tests;

public sealed class RecordedUnitsTests
{
    [Theory]
    [MemberData(nameof(WrittenStreams.Names), MemberType = typeof(WrittenStreams))]
    public void Every_split_keeps_every_byte(string name)
    {
        byte[] bytes = StreamFixture.Load(name).Bytes;
        for (int seed = 0; seed < 5; seed++)
        {
            using TemporaryFile file = Recordings.OfTcp([.. Splits.Random(bytes, new Random(seed)).Select(static (piece, i) => ((double)i, piece.ToArray()))]);
            using var units = new RecordedUnits(Open(file));
            for (int pass = 0; pass < 2; pass++)
            {
                Assert.Equal(bytes, ReadAll(units).SelectMany(static unit => unit.Bytes));
                units.Rewind();
            }
        }
    }

    [Fact]
    public void A_unit_is_a_packet_and_the_noise_before_it()
    {
        byte[] packet = TestPackets.Motion(0);
        using TemporaryFile file = Recordings.OfTcp((1, [7, 7, .. packet[..100]]), (2, [.. packet[100..], .. packet, 8, 8]), (3, [9]), (4, packet[..64]));
        using var units = new RecordedUnits(Open(file));
        Assert.Equal(
            [(packet.Length + 2, 2.0), (packet.Length, 2.0), (67, 4.0)],
            ReadAll(units).Select(static unit => (unit.Bytes.Length, unit.Time.TotalMilliseconds)));
    }

    [Fact]
    public void A_line_end_belongs_to_its_line()
    {
        byte[] line = TestPackets.Line(1);
        using TemporaryFile file = Recordings.OfTcp((1, line), (2, [.. line, .. line[..50]]), (3, line[50..]), (4, Encoding.ASCII.GetBytes("\r\n\r\n")));
        using var units = new RecordedUnits(Open(file));
        Assert.Equal([line, line, line, "\r\n\r\n"u8.ToArray()], ReadAll(units).Select(static unit => unit.Bytes));
    }

    [Fact]
    public void Units_stay_within_the_announced_length()
    {
        byte[] noise = new byte[200_000];
        new Random(1).NextBytes(noise);
        using TemporaryFile file = Recordings.OfTcp((1, [.. noise, .. TestPackets.Motion(0, count: 10_224)]), (2, noise));
        using var units = new RecordedUnits(Open(file));
        List<(byte[] Bytes, TimeSpan Time)> all = ReadAll(units);
        Assert.All(all, static unit => Assert.InRange(unit.Bytes.Length, 1, UnitParser.LongestUnit(10_224)));
        Assert.Equal([.. noise, .. TestPackets.Motion(0, count: 10_224), .. noise], all.SelectMany(static unit => unit.Bytes));
    }

    [Fact]
    public void Each_sender_has_whole_units()
    {
        (byte[] first, byte[] second) = (TestPackets.Motion(1), TestPackets.Motion(2));
        using TemporaryFile file = Recordings.Write(writer =>
        {
            writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Udp, string.Empty, string.Empty));
            writer.AddSender(TimeSpan.Zero, 0, 0, "10.0.0.1:5000");
            writer.AddSender(TimeSpan.Zero, 0, 1, "10.0.0.2:5000");
            writer.WriteBytes(Recordings.At(1), 0, first.AsSpan(0, 1024), sender: 0);
            writer.WriteBytes(Recordings.At(2), 0, second.AsSpan(0, 1024), sender: 1);
            writer.WriteBytes(Recordings.At(3), 0, first.AsSpan(1024), sender: 0);
            writer.WriteBytes(Recordings.At(4), 0, second.AsSpan(1024), sender: 1);
        });
        using var units = new RecordedUnits(Open(file));
        Assert.Equal([first, second], ReadAll(units).Select(static unit => unit.Bytes));
    }

    private static RecordedEventSource Open(TemporaryFile file) => RecordedEventSource.Open(file.Path, new PlaybackOptions());

    private static List<(byte[] Bytes, TimeSpan Time)> ReadAll(RecordedUnits units)
    {
        List<(byte[], TimeSpan)> all = [];
        while (units.TryRead(out ReadOnlySpan<byte> unit, out TimeSpan time))
            all.Add((unit.ToArray(), time));

        return all;
    }
}
