using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// Decides for one consumer which frames it gets. Each avatar of each sender has a schedule for each kind of frame. The schedules of one avatar share
// their verdicts, so a motion frame and a calculation frame of the same index have the same fate. The receive thread decides; any thread reads the count.
internal sealed class FrameThinner(FrameThinning thinning)
{
    // A sender can invent avatar numbers. At this limit all schedules begin again, which costs some evenness.
    private const int MaxAvatars = 1024;

    private readonly Dictionary<(int Sender, uint Avatar), AvatarSchedule> _avatars = [];
    private AvatarSchedule? _last;
    private long _skipped;

    public long Skipped => Volatile.Read(ref _skipped);

    public bool Takes(in ReceivedPacket packet)
    {
        if (Find(packet.Origin, packet.AvatarIndex).Takes(packet))
            return true;

        Volatile.Write(ref _skipped, _skipped + 1);
        return false;
    }

    private AvatarSchedule Find(int origin, uint avatar)
    {
        if (_last is { } last && last.Origin == origin && last.Avatar == avatar)
            return last;

        int sender = PacketOrigin.SenderOf(origin);
        if (!_avatars.TryGetValue((sender, avatar), out AvatarSchedule? schedule))
        {
            if (_avatars.Count == MaxAvatars)
                _avatars.Clear();

            _avatars.Add((sender, avatar), schedule = new AvatarSchedule(thinning, origin, avatar));
        }
        else if (schedule.Origin != origin)
        {
            schedule.Continue(origin);
        }

        return _last = schedule;
    }

    private sealed class AvatarSchedule(FrameThinning thinning, int origin, uint avatar)
    {
        private readonly ThinningSchedule[] _kinds = CreateAll(thinning);

        public uint Avatar => avatar;

        public int Origin { get; private set; } = origin;

        // The sender restarted and can start its frame numbers anywhere.
        public void Continue(int newOrigin)
        {
            Origin = newOrigin;
            foreach (ThinningSchedule schedule in _kinds)
                schedule.Restart();
        }

        public bool Takes(in ReceivedPacket packet)
        {
            ThinningSchedule own = _kinds[(int)packet.Kind];
            uint? index = packet.Kind == PacketKind.Motion
                ? MotionHeader.ReadFrameIndex(packet.Bytes)
                : CalculationHeader.ReadFrameIndex(packet.Bytes);
            if (index is not { } number)
                return own.Decide(packet.Timestamp);

            ThinningSchedule? partner = null;
            foreach (ThinningSchedule other in _kinds)
            {
                if (other == own)
                    continue;

                // A kind that is alone follows again as soon as it shares a frame.
                if (other.FindVerdict(number) is { } verdict && (verdict || !own.IsAlone))
                    return own.Follow(other, number, packet.Timestamp, verdict);
                if (!own.IsAlone && !other.IsAlone && other.HasVerdicts)
                    partner = other;
            }

            return own.Decide(number, packet.Timestamp, partner);
        }

        private static ThinningSchedule[] CreateAll(FrameThinning thinning)
        {
            var kinds = new ThinningSchedule[(int)PacketKind.StudioCalculation + 1];
            for (int i = 0; i < kinds.Length; i++)
                kinds[i] = new ThinningSchedule(thinning);

            return kinds;
        }
    }
}
