using System.Diagnostics;
using System.Runtime.CompilerServices;
using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// Who is counted: one tracker for each kind of frame of each avatar of each sender. The receive thread writes, anyone reads.
internal sealed class AvatarTrackers(IDurationRecorder? intervals)
{
    // Anyone can make up senders and avatar numbers; past this many, one that is stale makes room. While none is, further frames are delivered
    // and counted in total only.
    public const int MaxTrackers = 1024;

    // So many every sender gets, whatever others make up; there are no more senders at a time than UdpSenders keeps.
    public const int TrackersOfSender = 16;
    private const int TrackerLimit = 2 * MaxTrackers;

    // Longer than a suit that sends is ever silent: whoever sends now cannot be pushed out by any flood.
    public static readonly long StaleAfter = 5 * Stopwatch.Frequency;

    private readonly Dictionary<(PacketKind Kind, int Sender, uint Avatar), AvatarTracker> _trackers = [];
    private readonly Dictionary<int, int> _countOfSender = [];
    private volatile AvatarTracker[] _published = [];
    private AvatarTracker? _last;
    private long _noneStaleBefore;

    public AvatarTracker[] All => _published;

    // Avatars take turns: the one that followed the last one before nearly always follows it now.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public AvatarTracker? Find(in ReceivedPacket packet, uint avatar)
    {
        if (_last?.Next is { } next && next.Avatar == avatar && next.Kind == packet.Kind && next.Origin == packet.Origin)
            return _last = next;

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
