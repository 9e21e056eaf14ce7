using System.Net;
using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>The input cut into datagrams of a few or of many senders. Every byte is delivered or skipped, once.</summary>
internal sealed class UdpTarget
{
    private const int MostSenders = 80;

    // As many as the joiner keeps: their datagrams push everybody else's unfinished packets out.
    private const int Flushers = 64;

    /// <summary>What it takes to remember all senders, and the smallest tail of each.</summary>
    public const long AllocatedForSenders = (MostSenders + Flushers) * 5 * 1024;

    private static readonly SocketAddress[] Addresses =
        [.. Enumerable.Range(1, MostSenders + Flushers).Select(port => new IPEndPoint(IPAddress.Loopback, port).Serialize())];

    private readonly PacketScanner _scanner = new();
    private readonly byte[] _noise = [0];

    public void Run(FuzzInput input)
    {
        var counts = new Counts();
        var joiner = new UdpSenders(_scanner, counts, new SenderFilter([]));
        int senders = input.Random.Below(4) == 0 ? MostSenders : input.Random.Between(1, 3);
        int largest = input.Random.Choose([64, 200, 1_024, 1_472, 9_000]);
        for (ArraySegment<byte> rest = input.Segment; rest.Count > 0;)
        {
            int size = Math.Min(rest.Count, input.Random.Between(1, largest));
            joiner.Push(Addresses[input.Random.Below(senders)], rest.Slice(0, size), timestamp: 0);
            rest = rest.Slice(size);
        }

        input.Digest.Add(counts.Digest);
        input.Found += counts.Packets;
        for (int i = 0; i < Flushers; i++)
            joiner.Push(Addresses[MostSenders + i], _noise, timestamp: 0);

        WrongResultException.ThrowUnless(
            counts.Bytes == input.Segment.Count + Flushers, "{0} bytes came out of {1}.", counts.Bytes - Flushers, input.Segment.Count);
    }

    private sealed class Counts : IPacketReceiver
    {
        private Digest _digest;

        public StreamTap? Tap => null;

        public long Bytes { get; private set; }

        public int Packets { get; private set; }

        public ulong Digest => _digest.Value;

        public void OnLinkOpened()
        {
        }

        public void OnLinkClosed()
        {
        }

        public void OnPacket(in ReceivedPacket packet)
        {
            _digest.Add((long)packet.Source);
            _digest.Add(packet.Bytes);
            Bytes += packet.IsText ? 0 : packet.Length;
            Packets++;
        }

        public void OnText(ReadOnlySpan<byte> bytes)
        {
            _digest.Add(bytes);
            Bytes += bytes.Length;
        }

        public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason)
        {
            _digest.Add((long)reason);
            _digest.Add(bytes);
            Bytes += bytes.Length;
        }
    }
}
