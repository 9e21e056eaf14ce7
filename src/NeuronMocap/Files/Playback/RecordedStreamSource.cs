using System.Globalization;
using System.Net;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Recording;

// Reads the stream of a recording. A file that continues another one starts with its own first bytes, not after the time of the earlier files.
internal sealed class RecordedStreamSource : RecordedEventSource
{
    // Maximum number of substitutes for sender addresses that are missing from the file. A reader has 64 senders at a time.
    private const int MaxInventedAddresses = 1024;

    private readonly RecordingReader _reader;
    private readonly TimeSpan _origin;
    private readonly Dictionary<int, RecordedConnection> _connections = [];
    private readonly Dictionary<int, Dictionary<int, SocketAddress>> _senders = [];
    private int _invented;
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

    public override int MaxValues => Math.Min(_reader.Metadata.MaxValues ?? ProtocolConstants.DefaultMaxValues, ProtocolConstants.LargestMaxValues);

    public override RecordedEvent Read()
    {
        while (_reader.TryRead(out RecordingEntry entry))
        {
            TimeSpan time = TimeOf(entry);
            switch (entry.Kind)
            {
                case RecordingEntryKind.ConnectionOpened:
                    _connections[entry.Connection] = entry.Opened!;
                    return Of(RecordedEventKind.Opened, time, entry.Connection) with { WasOpen = entry.Opened!.WasOpen };
                case RecordingEntryKind.SenderAdded:
                    SendersOf(entry.Connection)[entry.Sender] = ParseAddress(entry.Text);
                    break;
                case RecordingEntryKind.SenderRemoved:
                    if (_senders.TryGetValue(entry.Connection, out Dictionary<int, SocketAddress>? senders))
                        senders.Remove(entry.Sender);

                    break;
                case RecordingEntryKind.Bytes:
                    return ReadBytes(entry, time);
                case RecordingEntryKind.BytesLost:
                    return Of(RecordedEventKind.Lost, time, entry.Connection);
                case RecordingEntryKind.Damaged:
                    return new RecordedEvent(RecordedEventKind.Lost, time) { IsDamage = true };
                case RecordingEntryKind.ConnectionClosed:
                    RecordedEvent closed = Of(RecordedEventKind.Closed, time, entry.Connection) with { Reason = entry.Text };
                    Forget(entry.Connection);
                    return closed;
            }
        }

        return new RecordedEvent(RecordedEventKind.End, Duration);
    }

    public override bool Seek(TimeSpan time)
    {
        // The reader repeats the open connections and senders of the new position.
        _connections.Clear();
        _senders.Clear();
        _reader.Seek(time + _origin);
        return time <= TimeSpan.Zero;
    }

    public override void Dispose() => _reader.Dispose();

    // Limits the time to the duration, even if the last block declares an earlier end than the entries show.
    private TimeSpan TimeOf(in RecordingEntry entry)
    {
        TimeSpan time = entry.Time > _origin ? entry.Time - _origin : TimeSpan.Zero;
        return time < Duration ? time : Duration;
    }

    private RecordedEvent ReadBytes(in RecordingEntry entry, TimeSpan time)
    {
        if (_buffer.Length < entry.Bytes.Length)
            _buffer = new byte[Math.Max(entry.Bytes.Length, 2 * _buffer.Length)];

        entry.Bytes.CopyTo(_buffer);
        RecordedEvent recorded = Of(RecordedEventKind.Bytes, time, entry.Connection);
        return recorded with
        {
            Bytes = new ArraySegment<byte>(_buffer, 0, entry.Bytes.Length),
            Sender = recorded.Transport == TransportKind.Udp ? FindSender(entry.Connection, entry.Sender) : null,
        };
    }

    private RecordedEvent Of(RecordedEventKind kind, TimeSpan time, int connection)
    {
        _connections.TryGetValue(connection, out RecordedConnection? known);
        return new(kind, time) { Connection = connection, Transport = known?.Transport ?? TransportKind.Tcp, IsCalculation = known?.IsCalculation ?? false };
    }

    // In a damaged file, the address of a sender may be missing. Its datagrams still receive an address of their own. The limit bounds the memory
    // for a hostile file.
    private SocketAddress FindSender(int connection, int sender)
    {
        if (SendersOf(connection).TryGetValue(sender, out SocketAddress? address))
            return address;

        address = new IPEndPoint(IPAddress.None, (ushort)sender).Serialize();
        if (_invented < MaxInventedAddresses)
        {
            SendersOf(connection)[sender] = address;
            _invented++;
        }

        return address;
    }

    private Dictionary<int, SocketAddress> SendersOf(int connection)
    {
        if (!_senders.TryGetValue(connection, out Dictionary<int, SocketAddress>? senders))
            _senders[connection] = senders = [];

        return senders;
    }

    private void Forget(int connection)
    {
        _connections.Remove(connection);
        _senders.Remove(connection);
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
