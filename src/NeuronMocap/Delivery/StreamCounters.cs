using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// Counts everything that came off the wire. The receive thread writes, anyone reads.
internal sealed class StreamCounters(IDurationRecorder? intervals = null)
{
    // Anyone can make up senders and avatar numbers; past this many, frames are delivered and counted in total only.
    private const int MaxTrackers = 1024;

    private readonly long[] _skippedByReason = new long[(int)SkipReason.Incomplete + 1];
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

    // Bytes of the skipped ones.
    public long GetSkipped(SkipReason reason) => Volatile.Read(ref _skippedByReason[(int)reason]);

    // A new connection stands.
    public void Resume()
    {
        Volatile.Write(ref _connections, _connections + 1);
        foreach (AvatarTracker tracker in _published)
            tracker.Resume();
    }

    public void CountMotion(in ReceivedPacket packet)
    {
        ReadOnlySpan<byte> header = packet.Bytes;
        Volatile.Write(ref _motionFrames, _motionFrames + 1);
        CountBytes(packet);
        Find(packet.Kind, packet.Source, MotionHeader.ReadAvatarIndex(header))
            ?.OnFrame(MotionHeader.ReadAvatarName(header), MotionHeader.ReadFrameIndex(header), packet.Timestamp);
    }

    public void CountCalculation(in ReceivedPacket packet)
    {
        ReadOnlySpan<byte> header = packet.Bytes;
        Volatile.Write(ref _calculationFrames, _calculationFrames + 1);
        CountBytes(packet);
        Find(packet.Kind, packet.Source, CalculationHeader.ReadAvatarIndex(header))
            ?.OnFrame(CalculationHeader.ReadAvatarName(header), CalculationHeader.ReadFrameIndex(header), packet.Timestamp);
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
        Volatile.Write(ref _skippedByReason[(int)reason], _skippedByReason[(int)reason] + bytes);
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
        Lost = _published.Sum(static tracker => tracker.Index.Lost),
        Gaps = _published.Sum(static tracker => tracker.Index.Gaps),
        Restarts = _published.Sum(static tracker => tracker.Index.Restarts),
    };

    private void CountBytes(in ReceivedPacket packet)
    {
        Volatile.Write(ref _bytes, _bytes + packet.Length);
        Volatile.Write(ref _lastFrame, packet.Timestamp);
        if (_firstFrame == 0)
            Volatile.Write(ref _firstFrame, packet.Timestamp);
    }

    // Avatars take turns: the one that followed the last one before nearly always follows it now.
    private AvatarTracker? Find(PacketKind kind, int source, uint avatar)
    {
        if (_last?.Next is { } next && next.Avatar == avatar && next.Kind == kind && next.Source == source)
            return _last = next;

        if (!_trackers.TryGetValue((kind, source, avatar), out AvatarTracker? tracker))
        {
            if (_trackers.Count >= MaxTrackers)
                return null;

            tracker = new AvatarTracker(kind, source, avatar, intervals);
            _trackers.Add((kind, source, avatar), tracker);
            _published = [.. _published, tracker];
        }

        if (_last is not null)
            _last.Next = tracker;

        return _last = tracker;
    }
}
