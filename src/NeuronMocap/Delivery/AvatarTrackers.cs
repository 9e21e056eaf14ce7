using System.Diagnostics;
using System.Runtime.CompilerServices;
using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// One tracker for each kind of frame, of each avatar, of each sender. The receive thread writes, any thread reads.
internal sealed class AvatarTrackers(IDurationRecorder? intervals)
{
    // A sender can invent avatar numbers, and the addresses of senders can be forged. At this limit, a new tracker replaces a stale one. If none is stale,
    // the frames are delivered but counted in the totals only.
    public const int MaxTrackers = 1024;

    // Each sender can have at least this many trackers, whatever others send. The number of senders is limited by UdpSenders.
    public const int TrackersOfSender = 16;
    private const int TrackerLimit = 2 * MaxTrackers;

    // Longer than an active suit is ever silent, so a flood cannot displace an active sender.
    public static readonly long StaleAfter = 5 * Stopwatch.Frequency;

    private readonly Dictionary<(PacketKind Kind, int Sender, uint Avatar), AvatarTracker> _trackers = [];
    private readonly Dictionary<int, int> _countOfSender = [];
    private volatile AvatarTracker[] _published = [];
    private AvatarTracker? _last;
    private long _noneStaleBefore;

    public AvatarTracker[] All => _published;

    // A server sends its avatars in a fixed order. The tracker that followed the last one in the previous round is therefore nearly always the next.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public AvatarTracker? Find(in ReceivedPacket packet, uint avatar)
    {
        if (_last?.Next is { } next && next.Avatar == avatar && next.Kind == packet.Kind && next.Origin == packet.Origin)
        {
            // For one avatar, both are the same. A store of a reference costs a call of the runtime.
            if (next != _last)
                _last = next;

            return next;
        }

        if (!_trackers.TryGetValue((packet.Kind, packet.Sender, avatar), out AvatarTracker? tracker))
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
        int ofSender = _countOfSender.GetValueOrDefault(packet.Sender);
        int? stalePlace = _published.Length < MaxTrackers ? null : FindStale(packet.Timestamp);
        if (stalePlace is { } place)
        {
            AvatarTracker stale = _published[place];
            tracker = new AvatarTracker(packet.Kind, packet.Origin, avatar, intervals, stale.Totals);
            Forget(stale);
            Volatile.Write(ref _published[place], tracker);
        }
        else if (_published.Length < MaxTrackers || (ofSender < TrackersOfSender && _published.Length < TrackerLimit))
        {
            tracker = new AvatarTracker(packet.Kind, packet.Origin, avatar, intervals);
            _published = [.. _published, tracker];
        }
        else
        {
            return null;
        }

        _countOfSender[packet.Sender] = _countOfSender.GetValueOrDefault(packet.Sender) + 1;
        _trackers.Add((packet.Kind, packet.Sender, avatar), tracker);
        return tracker;
    }

    // Returns the place of the oldest tracker if it is stale. Until the oldest can be stale, the method returns at once. A flood therefore causes a full
    // search only as often as one tracker is replaced. Timestamps grow, except those of datagrams that waited for up to a second; a stale tracker may be
    // found that much later.
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

    // Removes all references to the stale tracker; its avatar gets a new one.
    private void Forget(AvatarTracker stale)
    {
        _trackers.Remove((stale.Kind, stale.Sender, stale.Avatar));
        if (--_countOfSender[stale.Sender] == 0)
            _countOfSender.Remove(stale.Sender);

        foreach (AvatarTracker tracker in _published)
        {
            if (tracker.Next == stale)
                tracker.Next = null;
        }
    }
}
