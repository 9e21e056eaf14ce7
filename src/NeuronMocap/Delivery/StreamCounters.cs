using System.Diagnostics;
using System.Runtime.CompilerServices;
using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// Counts everything that came off the wire. The receive thread writes, anyone reads.
internal sealed class StreamCounters(IDurationRecorder? intervals = null)
{
    // Anyone can make up senders and avatar numbers; past this many, one that is stale makes room. While none is, further frames are delivered
    // and counted in total only.
    public const int MaxTrackers = 1024;

    // So many every sender gets, whatever others make up; there are no more senders at a time than UdpSenders keeps.
    public const int TrackersOfSource = 16;
    private const int MostTrackers = 2 * MaxTrackers;

    // Longer than a suit that sends is ever silent: whoever sends now cannot be pushed out by any flood.
    public static readonly long StaleAfter = 5 * Stopwatch.Frequency;

    private readonly long[] _skippedByReason = new long[(int)SkipReason.MissingAvatar + 1];
    private readonly Dictionary<(PacketKind Kind, int Source, uint Avatar), AvatarTracker> _trackers = [];
    private readonly Dictionary<int, int> _countOfSource = [];
    private volatile AvatarTracker[] _published = [];
    private AvatarTracker? _last;
    private long _noneStaleBefore;
    private long _bytes;
    private long _motionFrames;
    private long _calculationFrames;
    private long _studioFrames;
    private long _commandPackets;
    private long _emptyPackets;
    private long _skippedBytes;
    private long _oversizedPackets;
    private long _unknownVersions;
    private long _connections;
    private long _calculationConnections;
    private long _firstFrame;
    private long _lastFrame;

    public AvatarTracker[] Trackers => _published;

    // Bytes of the skipped ones.
    public long GetSkipped(SkipReason reason) => Volatile.Read(ref _skippedByReason[(int)reason]);

    // A new connection stands. That of a calculation port brings no motion; since there was one, the first connection is that of the motion.
    public void Resume(bool isCalculation = false)
    {
        if (isCalculation)
            Volatile.Write(ref _calculationConnections, _calculationConnections + 1);
        else
            Volatile.Write(ref _connections, _connections + 1);

        foreach (AvatarTracker tracker in _published)
        {
            bool isItsOwn = tracker.Kind == PacketKind.Motion ? !isCalculation : isCalculation || _calculationConnections == 0;
            if (isItsOwn)
                tracker.Resume();
        }
    }

    public void CountMotion(in ReceivedPacket packet)
    {
        ReadOnlySpan<byte> header = packet.Bytes;
        Volatile.Write(ref _motionFrames, _motionFrames + 1);
        CountBytes(packet);
        Find(packet, MotionHeader.ReadAvatarIndex(header))
            ?.OnFrame(MotionHeader.ReadAvatarName(header), MotionHeader.ReadFrameIndex(header), packet.Timestamp);
    }

    // Axis Neuron's or Axis Studio's, whose headers have these fields in the same places.
    public void CountCalculation(in ReceivedPacket packet)
    {
        ReadOnlySpan<byte> header = packet.Bytes;
        if (packet.Kind == PacketKind.Calculation)
            Volatile.Write(ref _calculationFrames, _calculationFrames + 1);
        else
            Volatile.Write(ref _studioFrames, _studioFrames + 1);

        CountBytes(packet);
        Find(packet, CalculationHeader.ReadAvatarIndex(header))
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

    // Of the text stream, as they came.
    public void CountText(int bytes) => Volatile.Write(ref _bytes, _bytes + bytes);

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

    // Asked for in every rendered frame by some: allocates nothing.
    public ReaderStatistics Snapshot()
    {
        LossTotals total = default;
        foreach (AvatarTracker tracker in _published)
            total = total.Add(tracker.Totals);

        return new ReaderStatistics
        {
            BytesReceived = Volatile.Read(ref _bytes),
            MotionFrames = Volatile.Read(ref _motionFrames),
            CalculationFrames = Volatile.Read(ref _calculationFrames),
            StudioCalculationFrames = Volatile.Read(ref _studioFrames),
            CommandPackets = Volatile.Read(ref _commandPackets),
            EmptyPackets = Volatile.Read(ref _emptyPackets),
            SkippedBytes = Volatile.Read(ref _skippedBytes),
            OversizedPackets = Volatile.Read(ref _oversizedPackets),
            UnknownVersionPackets = Volatile.Read(ref _unknownVersions),
            Reconnects = Math.Max(0, Volatile.Read(ref _connections) - 1),
            CalculationReconnects = Math.Max(0, Volatile.Read(ref _calculationConnections) - 1),
            FirstFrameTimestamp = Volatile.Read(ref _firstFrame),
            LastFrameTimestamp = Volatile.Read(ref _lastFrame),
            Lost = total.Lost,
            Gaps = total.Gaps,
            Restarts = total.Restarts,
        };
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void CountBytes(in ReceivedPacket packet)
    {
        if (!packet.IsText)
            Volatile.Write(ref _bytes, _bytes + packet.Length);

        // Datagrams that waited to be told apart are delivered with the time of their arrival, up to a second late.
        if (packet.Timestamp > _lastFrame)
            Volatile.Write(ref _lastFrame, packet.Timestamp);
        if (_firstFrame == 0)
            Volatile.Write(ref _firstFrame, packet.Timestamp);
    }

    // Avatars take turns: the one that followed the last one before nearly always follows it now.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private AvatarTracker? Find(in ReceivedPacket packet, uint avatar)
    {
        if (_last?.Next is { } next && next.Avatar == avatar && next.Kind == packet.Kind && next.Origin == packet.Origin)
            return _last = next;

        if (!_trackers.TryGetValue((packet.Kind, packet.Source, avatar), out AvatarTracker? tracker))
        {
            tracker = Add(packet, avatar);
            if (tracker is null)
                return null;
        }
        else if (tracker.Origin != packet.Origin)
        {
            tracker.Continue(packet.Origin);
        }

        if (_last is not null)
            _last.Next = tracker;

        return _last = tracker;
    }

    private AvatarTracker? Add(in ReceivedPacket packet, uint avatar)
    {
        AvatarTracker tracker;
        int ofSource = _countOfSource.GetValueOrDefault(packet.Source);
        int? stalePlace = _published.Length < MaxTrackers ? null : FindStale(packet.Timestamp);
        if (stalePlace is { } place)
        {
            AvatarTracker stale = _published[place];
            tracker = new AvatarTracker(packet.Kind, packet.Origin, avatar, intervals, stale.Totals);
            Forget(stale);
            Volatile.Write(ref _published[place], tracker);
        }
        else if (_published.Length < MaxTrackers || (ofSource < TrackersOfSource && _published.Length < MostTrackers))
        {
            tracker = new AvatarTracker(packet.Kind, packet.Origin, avatar, intervals);
            _published = [.. _published, tracker];
        }
        else
        {
            return null;
        }

        _countOfSource[packet.Source] = _countOfSource.GetValueOrDefault(packet.Source) + 1;
        _trackers.Add((packet.Kind, packet.Source, avatar), tracker);
        return tracker;
    }

    // The oldest one's place. Before the oldest can be stale there is nothing to look for, so that a flood costs a look at all of them only as often
    // as one of them is replaced. Timestamps grow, but for datagrams that waited for up to a second: by so much a stale one may be found late.
    private int? FindStale(long now)
    {
        if (now < _noneStaleBefore)
            return null;

        AvatarTracker[] trackers = _published;
        int oldest = 0;
        for (int i = 1; i < trackers.Length; i++)
        {
            if (trackers[i].LastTimestamp < trackers[oldest].LastTimestamp)
                oldest = i;
        }

        _noneStaleBefore = trackers[oldest].LastTimestamp + StaleAfter;
        return now < _noneStaleBefore ? null : oldest;
    }

    // Nobody may find it any more: its avatar gets a tracker anew.
    private void Forget(AvatarTracker stale)
    {
        _trackers.Remove((stale.Kind, stale.Source, stale.Avatar));
        if (--_countOfSource[stale.Source] == 0)
            _countOfSource.Remove(stale.Source);

        foreach (AvatarTracker tracker in _published)
        {
            if (tracker.Next == stale)
                tracker.Next = null;
        }
    }
}
