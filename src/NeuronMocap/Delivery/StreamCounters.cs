using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// Counts everything that came off the wire. The receive thread writes, anyone reads.
internal sealed class StreamCounters
{
    // Anyone can make up senders and avatar numbers; past this many, frames are delivered and counted in total only.
    private const int MaxTrackers = 1024;

    private readonly Dictionary<(PacketKind Kind, int Source, uint Avatar), AvatarTracker> _trackers = [];
    private volatile AvatarTracker[] _published = [];
    private AvatarTracker? _last;
    private long _bytes;
    private long _motionFrames;
    private long _calculationFrames;
    private long _commandPackets;
    private long _emptyPackets;
    private long _skippedBytes;
    private long _oversizedPackets;
    private long _unknownVersions;
    private long _connections;
    private long _firstFrame;
    private long _lastFrame;

    public AvatarTracker[] Trackers => _published;

    // A new connection stands.
    public void Resume()
    {
        Volatile.Write(ref _connections, _connections + 1);
        foreach (AvatarTracker tracker in _published)
            tracker.Resume();
    }

    public void CountFrame(in ReceivedPacket packet, in MotionHeader header)
    {
        Volatile.Write(ref _motionFrames, _motionFrames + 1);
        CountBytes(packet);
        Find(packet.Kind, packet.Source, header.AvatarIndex)?.OnFrame(header.AvatarName, header.FrameIndex, packet.Timestamp);
    }

    public void CountFrame(in ReceivedPacket packet, in CalculationHeader header)
    {
        Volatile.Write(ref _calculationFrames, _calculationFrames + 1);
        CountBytes(packet);
        Find(packet.Kind, packet.Source, header.AvatarIndex)?.OnFrame(header.AvatarName, header.FrameIndex, packet.Timestamp);
    }

    public void CountCommand(int bytes)
    {
        Volatile.Write(ref _commandPackets, _commandPackets + 1);
        Volatile.Write(ref _bytes, _bytes + bytes);
    }

    public void CountEmpty(int bytes)
    {
        Volatile.Write(ref _emptyPackets, _emptyPackets + 1);
        Volatile.Write(ref _bytes, _bytes + bytes);
    }

    public void CountSkipped(int bytes, SkipReason reason)
    {
        Volatile.Write(ref _skippedBytes, _skippedBytes + bytes);
        Volatile.Write(ref _bytes, _bytes + bytes);
        if (reason == SkipReason.TooLarge)
            Volatile.Write(ref _oversizedPackets, _oversizedPackets + 1);
        else if (reason == SkipReason.UnknownVersion)
            Volatile.Write(ref _unknownVersions, _unknownVersions + 1);
    }

    public ReaderStatistics Snapshot() => new()
    {
        BytesReceived = Volatile.Read(ref _bytes),
        MotionFrames = Volatile.Read(ref _motionFrames),
        CalculationFrames = Volatile.Read(ref _calculationFrames),
        CommandPackets = Volatile.Read(ref _commandPackets),
        EmptyPackets = Volatile.Read(ref _emptyPackets),
        SkippedBytes = Volatile.Read(ref _skippedBytes),
        OversizedPackets = Volatile.Read(ref _oversizedPackets),
        UnknownVersionPackets = Volatile.Read(ref _unknownVersions),
        Reconnects = Math.Max(0, Volatile.Read(ref _connections) - 1),
        FirstFrameTimestamp = Volatile.Read(ref _firstFrame),
        LastFrameTimestamp = Volatile.Read(ref _lastFrame),
        Lost = _published.Sum(static tracker => tracker.Snapshot.Lost),
    };

    private void CountBytes(in ReceivedPacket packet)
    {
        Volatile.Write(ref _bytes, _bytes + packet.Bytes.Count);
        Volatile.Write(ref _lastFrame, packet.Timestamp);
        if (_firstFrame == 0)
            Volatile.Write(ref _firstFrame, packet.Timestamp);
    }

    // Most streams have one avatar: the last tracker is nearly always the right one.
    private AvatarTracker? Find(PacketKind kind, int source, uint avatar)
    {
        if (_last is { } last && last.Kind == kind && last.Source == source && last.Avatar == avatar)
            return last;

        if (!_trackers.TryGetValue((kind, source, avatar), out AvatarTracker? tracker))
        {
            if (_trackers.Count >= MaxTrackers)
                return null;

            tracker = new AvatarTracker(kind, source, avatar);
            _trackers.Add((kind, source, avatar), tracker);
            _published = [.. _published, tracker];
        }

        return _last = tracker;
    }
}
