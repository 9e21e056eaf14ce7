using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Recording;

// Parses events to packets with the same code as bytes from a socket (TcpLink, UdpLink). A recording has one connection at a time, or two if
// calculation data has its own connection.
internal sealed class RecordedEventParser(int maxValues, SenderFilter filter, IPacketReceiver receiver)
{
    private readonly PacketScanner _scanner = new(maxValues);
    private readonly CalculationOnlyReceiver _calculation = new(receiver);
    private readonly Parser?[] _parsers = new Parser?[2];
    private UdpServers _servers = new();

    // The time of the recording. Silent senders are therefore detected as they were then, at any speed.
    private long _clock;

    public bool IsOpen => _parsers[0] is not null || _parsers[1] is not null;

    // The connection of the last event.
    public int Connection { get; private set; }

    // Whether an event belongs to an open connection.
    public bool Continues(in RecordedEvent recorded) => ParserOf(recorded) is { } parser && parser.Connection == recorded.Connection;

    // Whether an event implies that an open connection has ended.
    public bool Ends(in RecordedEvent recorded) =>
        recorded.Kind is RecordedEventKind.Opened or RecordedEventKind.Bytes && ParserOf(recorded) is { } parser && parser.Connection != recorded.Connection;

    // A connection without its beginning is joined late, because its first bytes may be the middle of a packet. Over UDP, the first datagram of
    // each sender shows whether it starts a packet.
    public void Open(in RecordedEvent recorded)
    {
        Close(ParserOf(recorded));
        Connection = recorded.Connection;
        var parser = new Parser(recorded.Connection);
        IPacketReceiver target = recorded.IsCalculation ? _calculation : receiver;
        if (recorded.Transport == TransportKind.Udp)
            parser.Udp = new UdpSenders(_scanner, target, filter, _servers);
        else
            parser.Tcp = new PacketAssembler(_scanner, target);

        if (recorded.Kind != RecordedEventKind.Opened || recorded.WasOpen)
            parser.Tcp?.JoinLate();

        _parsers[PlaceOf(recorded)] = parser;
    }

    // Returns true if the event opened a connection.
    public bool Follow(in RecordedEvent recorded, long timestamp)
    {
        _clock = ToClock(recorded.Time);
        bool isNew = recorded.Kind is RecordedEventKind.Opened or RecordedEventKind.Bytes && !Continues(recorded);
        if (isNew)
            Open(recorded);

        if (recorded.Kind == RecordedEventKind.Bytes)
            Push(ParserOf(recorded)!, recorded, timestamp);
        else if (recorded.Kind == RecordedEventKind.Lost)
            Abandon(recorded);
        else if (recorded.Kind == RecordedEventKind.Closed && Continues(recorded))
            Close(ParserOf(recorded));

        return isNew;
    }

    // Over UDP, closing the port does not wait for further packets and does not report incomplete ones.
    public void Close(TimeSpan? end = null)
    {
        if (end is { } time)
            _clock = ToClock(time);

        Close(_parsers[0]);
        Close(_parsers[1]);
        _servers = new UdpServers();
    }

    // Ends the wait of datagrams for their sender to be identified.
    public void Settle()
    {
        foreach (Parser? parser in _parsers)
            parser?.Udp?.Settle(_clock, isLast: true);
    }

    private static long ToClock(TimeSpan time) => RecordedTime.ToTimestamp(time);

    private static int PlaceOf(in RecordedEvent recorded) => recorded.IsCalculation ? 1 : 0;

    private Parser? ParserOf(in RecordedEvent recorded) => _parsers[PlaceOf(recorded)];

    // Bytes after a loss do not continue a packet. The datagram after a missing one reveals the gap.
    private void Abandon(in RecordedEvent recorded)
    {
        foreach (Parser? parser in _parsers)
        {
            if (recorded.IsDamage || parser == ParserOf(recorded))
                parser?.Tcp?.Abandon();
        }
    }

    private void Push(Parser parser, in RecordedEvent recorded, long timestamp)
    {
        Connection = recorded.Connection;
        if (parser.Udp is not null)
            parser.Udp.Push(recorded.Sender!, recorded.Bytes, timestamp, _clock);
        else
            parser.Tcp!.Push(recorded.Bytes, timestamp);
    }

    private void Close(Parser? parser)
    {
        parser?.Udp?.Settle(_clock, isLast: true);
        parser?.Tcp?.Abandon();
        for (int i = 0; i < _parsers.Length; i++)
        {
            if (_parsers[i] == parser)
                _parsers[i] = null;
        }
    }

    private sealed class Parser(int connection)
    {
        public int Connection => connection;

        public PacketAssembler? Tcp { get; set; }

        public UdpSenders? Udp { get; set; }
    }
}
