using System.Diagnostics;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Recording;

// The way from arrivals to packets: the very one that bytes take from a socket (TcpLink, UdpLink). A recording has one connection at a time, or two, where
// calculation data came over one of its own.
internal sealed class RecordedEventParser(int maxValues, SenderFilter filter, IPacketReceiver receiver)
{
    private readonly PacketScanner _scanner = new(maxValues);
    private readonly CalculationOnlyReceiver _calculation = new(receiver);
    private readonly Parser?[] _parsers = new Parser?[2];
    private UdpServers _servers = new();

    // The recording's, so that it is told as it was then who was silent, at any speed.
    private long _clock;

    public bool IsOpen => _parsers[0] is not null || _parsers[1] is not null;

    // Of the newest arrival.
    public int Connection { get; private set; }

    // Whether an arrival belongs to a connection that is open.
    public bool Continues(in RecordedEvent recorded) => ParserOf(recorded) is { } parser && parser.Connection == recorded.Connection;

    // Whether a connection that is open must have ended before an arrival.
    public bool Ends(in RecordedEvent recorded) =>
        recorded.Kind is RecordedEventKind.Opened or RecordedEventKind.Bytes && ParserOf(recorded) is { } parser && parser.Connection != recorded.Connection;

    // One whose beginning is not there is joined late: nobody knows whether its first bytes begin anything. Over UDP each sender's first datagram tells.
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

    // True when a connection stands that did not before.
    public bool Follow(in RecordedEvent recorded, long timestamp)
    {
        _clock = ToClock(recorded.Time);
        bool isNew = recorded.Kind is RecordedEventKind.Opened or RecordedEventKind.Bytes && !Continues(recorded);
        if (isNew)
            Open(recorded);

        if (recorded.Kind == RecordedEventKind.Bytes)
            Push(ParserOf(recorded)!, recorded, timestamp);
        else if (recorded.Kind == RecordedEventKind.Lost)
            ParserOf(recorded)?.Tcp?.Abandon();
        else if (recorded.Kind == RecordedEventKind.Closed && Continues(recorded))
            Close(ParserOf(recorded));

        return isNew;
    }

    // Over UDP no packet is waited for when the port is closed, and nothing is said to be incomplete.
    public void Close(TimeSpan? end = null)
    {
        if (end is { } time)
            _clock = ToClock(time);

        Close(_parsers[0]);
        Close(_parsers[1]);
        _servers = new UdpServers();
    }

    // Datagrams do not wait any longer to be told whose they are.
    public void Settle()
    {
        foreach (Parser? parser in _parsers)
            parser?.Udp?.Settle(_clock, isLast: true);
    }

    private static long ToClock(TimeSpan time) => (long)(time.TotalSeconds * Stopwatch.Frequency);

    private static int PlaceOf(in RecordedEvent recorded) => recorded.IsCalculation ? 1 : 0;

    private Parser? ParserOf(in RecordedEvent recorded) => _parsers[PlaceOf(recorded)];

    // What follows a loss continues nothing. That a datagram is missing shows in the one that follows it.
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
