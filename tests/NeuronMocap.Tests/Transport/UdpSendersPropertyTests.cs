using System.Diagnostics;
using System.Net;
using FsCheck;
using FsCheck.Fluent;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Transport;

/// <summary>Generated datagrams, read by <see cref="UdpSenders"/> and by <see cref="ReferenceSenders"/>.</summary>
public sealed class UdpSendersPropertyTests
{
    private readonly PacketScanner _scanner = new(WireStream.MaxValues);

    // Payload without any part that looks like a header.
    private static readonly Gen<WirePart> Frame =
        from shape in Gen.Elements(WireShape.NewMotion, WireShape.OldMotion, WireShape.Calculation)
        from count in Gen.Choose(1, WireStream.MaxValues)
        from avatar in Gen.Choose(0, 200)
        select (WirePart)new Packet(shape, count, Filling.Numbers, (uint)avatar);

    [Fact]
    public void Datagrams_of_a_few_senders_match_the_reference_joiner() => HoldsForSenders(3, mostFrames: 24, count: 2_000);

    [Fact]
    public void Datagrams_of_too_many_senders_match_the_reference_joiner() => HoldsForSenders(90, mostFrames: 400, count: 50);

    [Fact]
    public void Consecutive_halves_of_a_sender_are_delivered()
    {
        int joined = 0;
        Properties.Hold(Sending(4, 24, Frame), Simpler, count: 1_000, frames =>
        {
            List<Datagram> arrivals = SentFrame.Arrivals(frames);
            List<byte[]> delivered = [.. Receive(arrivals).Packets.Select(packet => packet.Bytes)];
            foreach (SentFrame frame in frames.DistinctBy(frame => (frame.Sender, frame.Part)))
            {
                byte[] bytes = frame.Part.ToBytes();
                int whole = CountHalves([.. arrivals.Where(datagram => datagram.Sender == frame.Sender)], bytes);
                joined += whole;
                Assert.True(delivered.Count(packet => packet.AsSpan().SequenceEqual(bytes)) >= whole, $"{frame} is missing.");
            }
        });
        Assert.True(joined > Trials.Fewest(1_000), $"Only {joined} frames came in halves: the cases are too poor to prove anything.");
    }

    // The maximum number of hosts, and a few that send from several ports. Whoever sends, gives way or is replaced, every byte is delivered once.
    [Fact]
    public void Every_byte_of_many_senders_is_delivered_or_skipped()
    {
        byte[] frame = TestPackets.Motion(1);
        Gen<Spoken[]> cases =
            from count in Gen.Choose(1, 60)
            from spoken in Spoken.Any.ArrayOf(count)
            select spoken;
        Properties.Hold(cases, list => Properties.SimplerLists(list, static _ => []), count: 1_000, list =>
        {
            var log = new PacketLog();
            var senders = new UdpSenders(new PacketScanner(), log, new SenderFilter([]));
            long now = 0;
            long pushed = 0;
            void Push(int host, int port, byte[] bytes)
            {
                senders.Push(new IPEndPoint(new IPAddress([127, 0, 1, (byte)host]), port).Serialize(), bytes, now);
                pushed += bytes.Length;
                Assert.InRange(senders.Count, 0, UdpSenders.Limit);
            }

            for (int host = Spoken.Hosts + 1; host < Spoken.Hosts + UdpSenders.Limit; host++)
                Push(host, 5000, frame);

            foreach (Spoken spoken in list)
            {
                now += Stopwatch.Frequency * spoken.Milliseconds / 1000;
                Push(spoken.Host, spoken.Port, spoken.Part switch { 0 => frame, 1 => frame[..1024], _ => frame[1024..] });
            }

            // A sender gives up an unfinished frame for a whole one.
            senders.Settle(now, isLast: true);
            for (int host = 1; host <= Spoken.Hosts; host++)
            {
                for (int port = 5000; port < 5000 + Spoken.Ports; port++)
                    Push(host, port, frame);
            }

            senders.Settle(now, isLast: true);
            Assert.Equal(pushed, log.Skipped + log.Packets.Sum(static packet => (long)packet.Bytes.Length));
        });
    }

    private void HoldsForSenders(int senders, int mostFrames, int count)
    {
        Gen<WirePart> parts = Gen.Frequency((4, Frame), (1, WireStream.AnyPart));
        Properties.Hold(Sending(senders, mostFrames, parts), Simpler, count, frames =>
        {
            List<Datagram> arrivals = SentFrame.Arrivals(frames);
            var expected = new ReferenceSenders(WireStream.MaxValues);
            foreach (Datagram datagram in arrivals)
                expected.Receive(datagram);

            PacketLog received = Receive(arrivals);
            Same.Items(expected.Packets.Select(static packet => packet.Source), received.Packets.Select(static packet => packet.Sender));
            Same.Packets(expected.Packets.Select(static packet => packet.Bytes), received.Packets.Select(static packet => packet.Bytes));
            Assert.Equal(expected.Skipped, received.Skipped);
        });
    }

    private PacketLog Receive(List<Datagram> arrivals)
    {
        var log = new PacketLog();
        var senders = new UdpSenders(_scanner, log, new SenderFilter([]));
        foreach (Datagram datagram in arrivals)
            senders.Push(new IPEndPoint(new IPAddress([127, 0, 0, (byte)datagram.Sender]), 7000).Serialize(), datagram.Bytes, timestamp: 0);

        return log;
    }

    private static Gen<SentFrame[]> Sending(int senders, int mostFrames, Gen<WirePart> parts) =>
        from count in Gen.Choose(1, mostFrames)
        from frames in SentFrame.From(senders, parts).ArrayOf(count)
        select frames;

    private static IEnumerable<SentFrame[]> Simpler(SentFrame[] frames) => Properties.SimplerLists(frames, frame => frame.Simpler());

    // Counts how often two consecutive datagrams of one sender are the halves of these bytes, with a whole header in the first. A shorter first half
    // looks like the rest of earlier unfinished data.
    private static int CountHalves(List<Datagram> ofSender, byte[] bytes)
    {
        int count = 0;
        for (int i = 0; i + 1 < ofSender.Count; i++)
        {
            byte[] first = ofSender[i].Bytes;
            bool areHalves = first.Length >= 64 && first.Length < bytes.Length && bytes.AsSpan(0, first.Length).SequenceEqual(first)
                && bytes.AsSpan(first.Length).SequenceEqual(ofSender[i + 1].Bytes);
            count += areHalves ? 1 : 0;
        }

        return count;
    }

    // One datagram: a whole frame, or the first or second part of one.
    private sealed record Spoken(int Host, int Port, int Part, int Milliseconds)
    {
        public const int Hosts = 3;
        public const int Ports = 3;

        public static readonly Gen<Spoken> Any =
            from host in Gen.Choose(1, Hosts)
            from port in Gen.Choose(5000, 5000 + Ports - 1)
            from part in Gen.Choose(0, 2)
            from milliseconds in Gen.Elements(0, 1, 10, 10, 300, 2_000)
            select new Spoken(host, port, part, milliseconds);
    }
}
