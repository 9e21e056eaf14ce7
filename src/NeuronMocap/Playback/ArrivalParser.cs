using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Playback;

// The way from arrivals to packets: the very one that bytes take from a socket (TcpLink, UdpLink).
internal sealed class ArrivalParser(int maxValues, SenderFilter filter, IPacketReceiver receiver)
{
    private readonly PacketScanner _scanner = new(maxValues);
    private PacketAssembler? _tcp;
    private UdpSenders? _udp;
    private int _connection;

    public bool IsOpen => _tcp is not null || _udp is not null;

    // Whether an arrival belongs to the connection that is open.
    public bool Continues(in Arrival arrival) => IsOpen && arrival.Connection == _connection;

    public void Open(in Arrival arrival)
    {
        _connection = arrival.Connection;
        _tcp = null;
        _udp = null;
        if (arrival.Transport == TransportKind.Udp)
        {
            _udp = new UdpSenders(_scanner, receiver, filter);
            return;
        }

        _tcp = new PacketAssembler(_scanner, receiver);
        if (arrival.Kind != ArrivalKind.Opened || arrival.WasOpen)
            _tcp.JoinLate();
    }

    public void Push(in Arrival arrival, long timestamp)
    {
        if (_udp is not null)
            _udp.Push(arrival.Sender!, arrival.Bytes, timestamp);
        else
            _tcp!.Push(arrival.Bytes, timestamp);
    }

    // Bytes are missing: what follows continues nothing. A lost datagram is found out by what follows it.
    public void Lose() => _tcp?.Abandon();

    public void Close()
    {
        _tcp?.Abandon();
        _tcp = null;
        _udp = null;
    }
}
