using System.Diagnostics;
using System.Net;
using NeuronMocap.Fuzz.Inputs;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Fuzz.Targets;

/// <summary>The input divided into datagrams of few or many senders. Every byte is delivered or skipped exactly once.</summary>
internal sealed class UdpTarget
{
    private const int MostSenders = 80;

    /// <summary>The memory for all senders, the smallest tail of each, and a waiting datagram.</summary>
    public const long AllocatedForSenders = (MostSenders * 8 * 1024) + (64 * 1024);

    /// <summary>Beyond the limit of the library, senders displace each other, and the next datagram of a displaced one makes a new one, of up to 5 KB.</summary>
    public const long AllocatedPerByte = 64;

    // Some senders have their own computer, others share one.
    private static readonly SocketAddress[] Addresses =
        [.. Enumerable.Range(1, MostSenders).Select(number => new IPEndPoint(new IPAddress([127, 0, 0, (byte)(1 + (number % 50))]), number).Serialize())];

    private static readonly byte[] Frame = CreateFrame();

    private readonly PacketScanner _scanner = new();

    public void Run(FuzzInput input)
    {
        var counts = new Counts();
        var joiner = new UdpSenders(_scanner, counts, new SenderFilter([]));
        int senders = input.Random.Below(4) == 0 ? MostSenders : input.Random.Between(1, 3);
        int largest = input.Random.Choose([64, 200, 1_024, 1_472, 9_000]);
        long now = 1;
        for (ArraySegment<byte> rest = input.Segment; rest.Count > 0;)
        {
            int size = Math.Min(rest.Count, input.Random.Between(1, largest));
            now += input.Random.Below(16) == 0 ? Stopwatch.Frequency : Stopwatch.Frequency / 100;
            joiner.Push(Addresses[input.Random.Below(senders)], rest.Slice(0, size), now);
            rest = rest.Slice(size);
        }

        input.Digest.Add(counts.Digest);
        input.Found += counts.Packets;

        // A sender gives up an unfinished packet for a whole one.
        joiner.Settle(now, isLast: true);
        foreach (SocketAddress address in Addresses)
            joiner.Push(address, Frame, now);

        joiner.Settle(now, isLast: true);
        long flushed = (long)Addresses.Length * Frame.Length;
        WrongResultException.ThrowUnless(
            counts.Bytes == input.Segment.Count + flushed, "{0} bytes came out of {1}.", counts.Bytes - flushed, input.Segment.Count);
    }

    private static byte[] CreateFrame()
    {
        byte[] frame = new byte[ProtocolConstants.HeaderSize];
        new MotionHeader { Version = DataVersion.New }.Write(frame);
        return frame;
    }

    private sealed class Counts : IPacketReceiver
    {
        private Digest _digest;

        public long Bytes { get; private set; }

        public int Packets { get; private set; }

        public ulong Digest => _digest.Value;

        public void OnPacket(in ReceivedPacket packet)
        {
            _digest.Add((long)packet.Sender);
            _digest.Add(packet.Bytes);
            Bytes += packet.IsText ? 0 : packet.Length;
            Packets++;
        }

        public void OnText(ReadOnlySpan<byte> bytes, PacketKind kind)
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
