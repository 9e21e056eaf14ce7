using System.Diagnostics;
using System.Diagnostics.CodeAnalysis;

namespace NeuronMocap.RabbitMq.Publishing;

// Packets between the reader and the broker: first waiting, then, if the broker confirms, sent. A full outbox drops its oldest waiting packet, so the
// reader's side never waits. All members are for any thread; the lock is never held while code of others runs.
[SuppressMessage("Design", "CA1001", Justification = "The semaphore holds no handle, and may be released after the end.")]
internal sealed class Outbox(RabbitMqPublisherOptions options, bool confirms)
{
    private const int MaxRoutes = 4096;

    private readonly object _lock = new();
    private readonly SemaphoreSlim _signal = new(0);
    private readonly Dictionary<(PacketKind Kind, int Sender, int Avatar), Route> _routes = [];
    private readonly Dictionary<string, FrameNumber> _numbers = new(StringComparer.Ordinal);
    private readonly Stack<Parcel> _free = new();
    private readonly ParcelRing _waiting = new(options.Capacity);
    private readonly ParcelRing _sent = new(confirms ? options.Capacity : 0);
    private long _run = NewRun();
    private int _parcels;
    private ulong _nextTag = 1;
    private bool _isComplete;
    private bool _isAwaited;
    private long _frames;
    private long _dropped;
    private long _published;
    private long _confirmed;
    private long _repeated;
    private long _bytes;

    // The handler of a queue.
    public void Add(AvatarFrame frame)
    {
        long age = Stopwatch.GetTimestamp() - frame.Timestamp;
        long captured = ((DateTime.UtcNow - DateTimeOffset.UnixEpoch.UtcDateTime).Ticks / 10) - (long)(age * (1e6 / Stopwatch.Frequency));
        lock (_lock)
        {
            _frames++;
            Route route = FindRoute(frame);
            long number = ++route.Number.Last;
            if (TakeFree() is { } parcel)
            {
                parcel.Fill(route, number, captured, frame.Packet);
                _waiting.AddLast(parcel);
                Wake();
            }
            else
            {
                _dropped++;
            }
        }
    }

    // The reader has stopped.
    public void Complete()
    {
        lock (_lock)
        {
            _isComplete = true;
            Wake();
        }
    }

    // True: a packet waits. False: there will be none, and everything is sent and, if the broker confirms, confirmed.
    public async ValueTask<bool> WaitAsync(CancellationToken cancellationToken)
    {
        while (true)
        {
            lock (_lock)
            {
                if (_waiting.Count > 0)
                    return true;
                if (_isComplete && _sent.Count == 0)
                    return false;

                _isAwaited = true;
            }

            await _signal.WaitAsync(cancellationToken).ConfigureAwait(false);
        }
    }

    // The caller is the only one that takes. Without confirmations, it gives the packet back with Release.
    public Parcel? Take()
    {
        lock (_lock)
        {
            if (_waiting.Count == 0)
                return null;

            Parcel parcel = _waiting.RemoveFirst();
            if (confirms)
            {
                _sent.AddLast(parcel);
                _nextTag++;
            }

            return parcel;
        }
    }

    // With confirmations, the parcel may already hold another packet.
    public void CountPublished(Parcel parcel, int length)
    {
        lock (_lock)
        {
            _published++;
            _bytes += length;
            if (!confirms)
                _free.Push(parcel);
        }
    }

    // With confirmations, the next connection sends the packet.
    public void CountUnsent(Parcel parcel)
    {
        lock (_lock)
        {
            if (confirms)
                return;

            _free.Push(parcel);
            _dropped++;
        }
    }

    // The broker numbers the messages of a channel from 1. It confirms one message, or all up to one.
    public void Confirm(ulong tag, bool multiple)
    {
        lock (_lock)
        {
            ulong first = _nextTag - (ulong)_sent.Count;
            if (tag < first || tag >= _nextTag)
                return;

            int place = (int)(tag - first);
            for (int i = multiple ? 0 : place; i <= place; i++)
            {
                if (_sent[i].IsConfirmed)
                    continue;

                _sent[i].IsConfirmed = true;
                _confirmed++;
            }

            while (_sent.Count > 0 && _sent[0].IsConfirmed)
                _free.Push(_sent.RemoveFirst());

            Wake();
        }
    }

    // Before each connection. What was not confirmed is sent again, in order. Without confirmations, what waits is too old for live viewers.
    public void BeginConnection()
    {
        lock (_lock)
        {
            _nextTag = 1;
            while (_sent.Count > 0)
            {
                Parcel parcel = _sent.RemoveLast();
                if (parcel.IsConfirmed)
                {
                    _free.Push(parcel);
                }
                else
                {
                    _repeated++;
                    _waiting.AddFirst(parcel);
                }
            }

            while (!confirms && _waiting.Count > 0)
                Drop();
        }
    }

    public RabbitMqPublisherStatistics GetStatistics(long droppedBefore, int connections)
    {
        lock (_lock)
        {
            return new RabbitMqPublisherStatistics
            {
                Frames = _frames + droppedBefore,
                Published = _published,
                Confirmed = _confirmed,
                Repeated = _repeated,
                Dropped = _dropped + droppedBefore,
                Waiting = _waiting.Count,
                Unconfirmed = _sent.Count,
                Bytes = _bytes,
                Connections = connections,
            };
        }
    }

    private Route FindRoute(AvatarFrame frame)
    {
        PacketKind kind = frame switch
        {
            MotionFrame => PacketKind.Motion,
            CalculationFrame => PacketKind.Calculation,
            _ => PacketKind.StudioCalculation,
        };
        (PacketKind, int, int) id = (kind, frame.Sender, frame.AvatarIndex);
        if (_routes.TryGetValue(id, out Route? route) && string.Equals(route.Avatar, frame.AvatarName, StringComparison.Ordinal))
            return route;

        // A server can invent any number of avatars and names. Another run starts all numbers again.
        if (_routes.Count >= MaxRoutes || _numbers.Count >= MaxRoutes)
        {
            _routes.Clear();
            _numbers.Clear();
            _run = NewRun();
        }

        string key = RabbitMqRoutingKey.Create(options.Stage, frame.AvatarName, kind);
        if (!_numbers.TryGetValue(key, out FrameNumber? number))
            _numbers.Add(key, number = new FrameNumber());

        return _routes[id] = new Route(options.Stage, frame.AvatarName, kind, key, _run, number);
    }

    private static long NewRun() => BitConverter.ToInt64(Guid.NewGuid().ToByteArray(), 0);

    private Parcel? TakeFree()
    {
        if (_free.Count == 0 && _parcels < options.Capacity)
        {
            _parcels++;
            return new Parcel();
        }

        // If all packets are on their way, the newest one has no room.
        if (_free.Count == 0 && _waiting.Count > 0)
            Drop();

        return _free.Count > 0 ? _free.Pop() : null;
    }

    private void Drop()
    {
        _free.Push(_waiting.RemoveFirst());
        _dropped++;
    }

    private void Wake()
    {
        if (!_isAwaited)
            return;

        _isAwaited = false;
        _signal.Release();
    }
}
