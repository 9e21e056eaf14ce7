using System.Globalization;
using System.Net;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Skeleton;
using NeuronMocap.Transport;

namespace NeuronMocap.Playback;

// A recording as the stream that it holds. A file that continues another one begins with its own first bytes, not with the time of all before it.
internal sealed class RecordedStreamSource : ArrivalSource
{
    // What a reader's options allow.
    private const int MostValues = 1_000_000;

    private readonly RecordingReader _reader;
    private readonly TimeSpan _origin;
    private readonly Dictionary<int, RecordedConnection> _connections = [];
    private readonly Dictionary<(int Connection, int Sender), SocketAddress> _senders = [];
    private byte[] _buffer = [];

    public RecordedStreamSource(string path, RecordingReader reader)
        : base(path)
    {
        _reader = reader;
        if (reader.FileNumber > 1)
        {
            _origin = FindOrigin();
            Seek(TimeSpan.Zero);
        }
    }

    public override TimeSpan Duration => _reader.Duration > _origin ? _reader.Duration - _origin : TimeSpan.Zero;

    public override RotationOrder? RotationOrder => _reader.Metadata.RotationOrder;

    public override SkeletonVariant? SkeletonVariant => _reader.Metadata.SkeletonVariant;

    public override int MaxValues => Math.Min(_reader.Metadata.MaxValues ?? ProtocolConstants.DefaultMaxValues, MostValues);

    public override Arrival Read()
    {
        while (_reader.TryRead(out RecordingEntry entry))
        {
            TimeSpan time = entry.Time > _origin ? entry.Time - _origin : TimeSpan.Zero;
            switch (entry.Kind)
            {
                case RecordingEntryKind.ConnectionOpened:
                    _connections[entry.Connection] = entry.Opened!;
                    return Of(ArrivalKind.Opened, time, entry.Connection) with { WasOpen = entry.Opened!.WasOpen };
                case RecordingEntryKind.SenderAdded:
                    _senders[(entry.Connection, entry.Sender)] = ParseAddress(entry.Text);
                    break;
                case RecordingEntryKind.SenderRemoved:
                    _senders.Remove((entry.Connection, entry.Sender));
                    break;
                case RecordingEntryKind.Bytes:
                    return ReadBytes(entry, time);
                case RecordingEntryKind.BytesLost:
                case RecordingEntryKind.Damaged:
                    return Of(ArrivalKind.Lost, time, entry.Connection);
                case RecordingEntryKind.ConnectionClosed:
                    Arrival closed = Of(ArrivalKind.Closed, time, entry.Connection) with { Reason = entry.Text };
                    _connections.Remove(entry.Connection);
                    return closed;
            }
        }

        return new Arrival(ArrivalKind.End, Duration);
    }

    public override bool Seek(TimeSpan time)
    {
        _reader.Seek(time + _origin);
        return time <= TimeSpan.Zero;
    }

    public override void Dispose() => _reader.Dispose();

    private Arrival ReadBytes(in RecordingEntry entry, TimeSpan time)
    {
        if (_buffer.Length < entry.Bytes.Length)
            _buffer = new byte[Math.Max(entry.Bytes.Length, 2 * _buffer.Length)];

        entry.Bytes.CopyTo(_buffer);
        Arrival arrival = Of(ArrivalKind.Bytes, time, entry.Connection);
        return arrival with
        {
            Bytes = new ArraySegment<byte>(_buffer, 0, entry.Bytes.Length),
            Sender = arrival.Transport == TransportKind.Udp ? FindSender(entry.Connection, entry.Sender) : null,
        };
    }

    private Arrival Of(ArrivalKind kind, TimeSpan time, int connection) => new(kind, time)
    {
        Connection = connection,
        Transport = _connections.TryGetValue(connection, out RecordedConnection? known) ? known.Transport : TransportKind.Tcp,
    };

    // Where the file is damaged, a sender's address may be missing; its datagrams are still its own.
    private SocketAddress FindSender(int connection, int sender)
    {
        if (!_senders.TryGetValue((connection, sender), out SocketAddress? address))
            _senders[(connection, sender)] = address = new IPEndPoint(IPAddress.None, (ushort)sender).Serialize();

        return address;
    }

    private static SocketAddress ParseAddress(string? text)
    {
        int colon = text?.LastIndexOf(':') ?? -1;
        return colon > 0 && IPAddress.TryParse(text.AsSpan(0, colon), out IPAddress? address)
            && ushort.TryParse(text.AsSpan(colon + 1), NumberStyles.None, CultureInfo.InvariantCulture, out ushort port)
                ? new IPEndPoint(address, port).Serialize()
                : new IPEndPoint(IPAddress.None, 0).Serialize();
    }

    private TimeSpan FindOrigin()
    {
        while (_reader.TryRead(out RecordingEntry entry))
        {
            if (entry.Kind is RecordingEntryKind.Bytes or RecordingEntryKind.BytesLost || entry.Opened is { WasOpen: false })
                return entry.Time;
        }

        return TimeSpan.Zero;
    }
}
