using NeuronMocap.Protocol;
using NeuronMocap.RabbitMq.Connecting;

namespace NeuronMocap.RabbitMq.Consuming;

// What a source knows across its connections: the last frames, the place in the stream, the counts. The lock is for readers of the counts; messages come
// one at a time.
internal sealed class SourceState(RabbitMqSourceOptions options)
{
    // The reader applies its own limit.
    private readonly PacketScanner _scanner = new(ProtocolConstants.LargestMaxValues);
    private readonly object _lock = new();
    private readonly LossCounter _losses = new();
    private readonly string _pattern = RabbitMqRoutingKey.CreatePattern(options.Stage, options.Avatar, options.Kind);
    private readonly bool _isStream = options.Stream is not null;
    private RabbitMqStreamStart _start = options.From;
    private long? _earliest = options.From.EarliestCapture;
    private long _packets;
    private long _bytes;
    private long _invalid;
    private long _skipped;
    private StreamPlace? _last;
    private long? _lastCaptured;
    private bool _isResuming;
    private int _connections;

    public void CountConnection()
    {
        lock (_lock)
            _connections++;
    }

    // Where the next connection begins: with the last message again, which shows whether the stream is still the same.
    public object Resume()
    {
        lock (_lock)
        {
            _isResuming = _last is not null;
            return _last?.Offset ?? _start.Argument;
        }
    }

    // False if the first message of a connection is another one than the last of the connection before. If retention has removed that one, a later
    // one comes.
    public bool IsSameStream(string key, IDictionary<string, object?>? headers)
    {
        lock (_lock)
        {
            if (!_isResuming || StreamPlace.Find(key, headers) is not { } place)
                return true;

            _isResuming = false;
            if (place == _last || place.Offset > _last!.Value.Offset)
                return true;

            Restart();
            return false;
        }
    }

    // True if the first message of a connection has not come. A broker sends nothing from a stream that ends before the last message.
    public bool IsStreamOver()
    {
        lock (_lock)
        {
            bool isOver = _isResuming;
            if (isOver)
                Restart();

            return isOver;
        }
    }

    // Whether the reader gets the message.
    public bool Take(string key, IDictionary<string, object?>? headers, ReadOnlySpan<byte> body)
    {
        lock (_lock)
        {
            if (_isStream && StreamPlace.Find(key, headers) is { } place)
            {
                if (place.Offset <= _last?.Offset)
                    return false;

                _last = place;
                _lastCaptured = place.Captured ?? _lastCaptured;
            }

            if (_isStream && (!RabbitMqRoutingKey.Matches(_pattern, key) || IsTooEarly(headers)))
            {
                _skipped++;
                return false;
            }

            if (!IsFrame(body))
            {
                _invalid++;
                return false;
            }

            // Programs of others may publish packets without numbers.
            if (MessageHeaders.Find(headers, MessageHeaders.Run) is { } run && MessageHeaders.Find(headers, MessageHeaders.Number) is { } number && !_losses.Take(run, key, number))
                return false;

            _packets++;
            _bytes += body.Length;
            return true;
        }
    }

    public RabbitMqSourceStatistics GetStatistics()
    {
        lock (_lock)
        {
            return new RabbitMqSourceStatistics
            {
                Packets = _packets,
                Bytes = _bytes,
                Lost = _losses.Lost,
                Duplicates = _losses.Duplicates,
                Invalid = _invalid,
                Skipped = _skipped,
                LastOffset = _last?.Offset,
                Connections = _connections,
            };
        }
    }

    // Begins in the new stream with what was captured after the last message, and not before the time that the application chose. All clocks but the
    // source's own may be wrong.
    private void Restart()
    {
        long now = RabbitMqStreamStart.AtTime(DateTimeOffset.UtcNow).EarliestCapture!.Value;
        long? chosen = options.From.EarliestCapture;
        _start = (_lastCaptured ?? chosen) is { } captured
            ? RabbitMqStreamStart.AtCapture(Math.Max(Math.Clamp(captured, 0, now), chosen ?? 0))
            : RabbitMqStreamStart.First;
        _earliest = _start.EarliestCapture;
        (_last, _isResuming) = (null, false);
    }

    // The broker begins at a part of the stream before the time. A message of another program may have no time.
    private bool IsTooEarly(IDictionary<string, object?>? headers)
    {
        if (_earliest is not { } earliest || MessageHeaders.Find(headers, MessageHeaders.Captured) is not { } captured)
            return false;
        if (captured < earliest)
            return true;

        _earliest = null;
        return false;
    }

    private bool IsFrame(ReadOnlySpan<byte> body)
    {
        if (body.Length <= ProtocolConstants.HeaderSize)
            return false;

        ScanResult scan = _scanner.Scan(body);
        return scan.Status == ScanStatus.Packet && scan.Length == body.Length && scan.Kind != PacketKind.Command;
    }
}
