using System.Net;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// One assembler for every address that sends to the port: Axis Neuron on macOS cuts a frame into two datagrams, and two senders interleave
// (protocol.md section 4.2). Used by the receive loop alone.
internal sealed class UdpSenders(PacketScanner scanner, IPacketReceiver receiver, SenderFilter filter)
{
    // Anyone can send from thousands of forged addresses; the one that was silent longest makes room.
    public const int Limit = 64;

    // Servers that cut frames up cut them into pieces of this size (protocol.md sections 4.2 and 8): a larger datagram begins with a frame.
    private const int PieceSize = 1024;

    private readonly Dictionary<SocketAddress, Sender> _senders = new(SenderComparer.Instance);
    private int _nextSource;
    private long _clock;

    public int Count => _senders.Count;

    public void Push(SocketAddress address, ArraySegment<byte> datagram, long timestamp)
    {
        if (!_senders.TryGetValue(address, out Sender? sender))
        {
            if (!filter.Allows(address))
            {
                filter.CountRefused(address);
                return;
            }

            sender = Add(address);
            if (datagram.Count <= PieceSize)
                sender.Assembler.JoinLate();
        }

        sender.LastUsed = ++_clock;

        // A datagram that begins with a header cannot be the rest of the packet before it: that rest was lost. Joining the two would give
        // one frame made of two.
        if (sender.Assembler.PendingBytes > 0 && (scanner.StartsPacket(datagram) || sender.Assembler.StartsAnew(datagram)))
            sender.Assembler.Abandon();

        sender.Assembler.Push(datagram, timestamp);
    }

    private Sender Add(SocketAddress address)
    {
        if (_senders.Count >= Limit)
            RemoveOldest();

        (SocketAddress copy, byte[] bytes) = Copy(address);
        var sender = new Sender(new PacketAssembler(scanner, receiver, _nextSource++, bytes));
        _senders.Add(copy, sender);
        return sender;
    }

    private void RemoveOldest()
    {
        SocketAddress? oldest = null;
        long used = long.MaxValue;
        foreach ((SocketAddress address, Sender sender) in _senders)
        {
            if (sender.LastUsed >= used)
                continue;

            used = sender.LastUsed;
            oldest = address;
        }

        _senders[oldest!].Assembler.Abandon();
        _senders.Remove(oldest!);
    }

    // The receive loop uses its address object again for the next datagram.
    private static (SocketAddress Copy, byte[] Bytes) Copy(SocketAddress address)
    {
        var copy = new SocketAddress(address.Family, address.Size);
        byte[] bytes = new byte[address.Size];
        for (int i = 0; i < address.Size; i++)
            copy[i] = bytes[i] = address[i];

        return (copy, bytes);
    }

    private sealed class Sender(PacketAssembler assembler)
    {
        public PacketAssembler Assembler => assembler;

        public long LastUsed { get; set; }
    }
}
