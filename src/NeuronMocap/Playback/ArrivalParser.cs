using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Playback;

// The way from arrivals to packets: the very one that bytes take from a socket (TcpLink, UdpLink).
internal sealed class ArrivalParser(int maxValues, SenderFilter filter, IPacketReceiver receiver)
{
    private readonly PacketScanner _scanner = new(maxValues);
    private PacketAssembler? _tcp;
    private UdpSenders? _udp;

    public bool IsOpen => _tcp is not null || _udp is not null;

    // Of the connection that is open.
    public int Connection { get; private set; }

    // Whether an arrival belongs to the connection that is open.
    public bool Continues(in Arrival arrival) => IsOpen && arrival.Connection == Connection;

    // One whose beginning is not there is joined late: nobody knows whether its first bytes begin anything. Over UDP each sender's first datagram tells.
    public void Open(in Arrival arrival)
    {
        Close();
        Connection = arrival.Connection;
        if (arrival.Transport == TransportKind.Udp)
        {
            _udp = new UdpSenders(_scanner, receiver, filter);
            return;
        }

        _tcp = new PacketAssembler(_scanner, receiver);
        if (arrival.Kind != ArrivalKind.Opened || arrival.WasOpen)
            _tcp.JoinLate();
    }

    // True when a connection stands that did not before.
    public bool Follow(in Arrival arrival, long timestamp)
    {
        bool isNew = arrival.Kind is ArrivalKind.Opened or ArrivalKind.Bytes && !Continues(arrival);
        if (isNew)
            Open(arrival);

        if (arrival.Kind == ArrivalKind.Bytes)
            Push(arrival, timestamp);
        else if (arrival.Kind == ArrivalKind.Lost)
            Lose();
        else if (arrival.Kind == ArrivalKind.Closed && Continues(arrival))
            Close();

        return isNew;
    }

    // Over UDP no packet is waited for when the port is closed, and nothing is said to be incomplete.
    public void Close()
    {
        _tcp?.Abandon();
        _tcp = null;
        _udp = null;
    }

    private void Push(in Arrival arrival, long timestamp)
    {
        if (_udp is not null)
            _udp.Push(arrival.Sender!, arrival.Bytes, timestamp);
        else
            _tcp!.Push(arrival.Bytes, timestamp);
    }

    // What follows continues nothing. That a datagram is missing shows in the one that follows it.
    private void Lose() => _tcp?.Abandon();
}
