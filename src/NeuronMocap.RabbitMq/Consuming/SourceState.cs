using NeuronMocap.Protocol;
using NeuronMocap.RabbitMq.Connecting;

namespace NeuronMocap.RabbitMq.Consuming;

// What a source knows across its connections: the last frames, the place in the stream, the counts. The lock is for readers of the counts; messages come
// one at a time.
internal sealed class SourceState(RabbitMqSourceOptions options)
{
    private readonly object _lock = new();
    private readonly PacketScanner _scanner = new();
    private readonly LossCounter _losses = new();
    private readonly string _pattern = RabbitMqRoutingKey.CreatePattern(options.Stage, options.Avatar, options.Kind);
    private readonly bool _isStream = options.Stream is not null;
    private long? _earliest = options.From.EarliestCapture;
    private long _packets;
    private long _bytes;
    private long _invalid;
    private long _skipped;
    private long? _lastOffset;
    private int _connections;

    public void CountConnection()
    {
        lock (_lock)
            _connections++;
    }

    // Behind the last message; null before the first one.
    public object StreamOffset
    {
        get
        {
            lock (_lock)
                return _lastOffset + 1 ?? options.From.Argument;
        }
    }

    // Whether the reader gets the message.
    public bool Take(string key, IDictionary<string, object?>? headers, ReadOnlySpan<byte> body)
    {
        lock (_lock)
        {
            if (_isStream && Find(headers, MessageHeaders.StreamOffset) is { } offset)
                _lastOffset = offset;

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
            if (Find(headers, MessageHeaders.Run) is { } run && Find(headers, MessageHeaders.Number) is { } number && !_losses.Take(run, key, number))
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
                LastOffset = _lastOffset,
                Connections = _connections,
            };
        }
    }

    private static long? Find(IDictionary<string, object?>? headers, string name) =>
        headers is not null && headers.TryGetValue(name, out object? value) && value is long number ? number : null;

    // The broker begins at a part of the stream before the time. A message of another program may have no time.
    private bool IsTooEarly(IDictionary<string, object?>? headers)
    {
        if (_earliest is not { } earliest || Find(headers, MessageHeaders.Captured) is not { } captured)
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
