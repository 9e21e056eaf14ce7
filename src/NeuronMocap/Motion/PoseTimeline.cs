using NeuronMocap.Skeleton;

namespace NeuronMocap.Motion;

// Holds the frames of a sampler in the order of the sender's clock, and computes the poses between and after them. One thread.
internal sealed class PoseTimeline(PoseBufferOptions options, int capacity)
{
    // Frames closer than this count as one, because their difference does not define a speed.
    private const double MinInterval = 5e-5;

    // If this many consecutive frames are missing, the motion between is unknown and is not interpolated.
    private const double GapIntervals = 6;

    private readonly PoseSlot[] _slots = new PoseSlot[capacity];
    private readonly BoneTransform[] _held = new BoneTransform[BoneHierarchy.BoneCount];
    private readonly double _delay = options.Delay.TotalSeconds;
    private readonly double _reach = options.MaxExtrapolation.TotalSeconds;
    private readonly bool _isCubic = options.Interpolation == PoseInterpolationMethod.Cubic;

    private int _count;
    private double _interval;
    private bool _hasSpeed;

    // The tag of the last frame at or before the time of the latest sample, or else of the first frame.
    public long SampledTag { get; private set; }

    public void Add(PoseSlot slot)
    {
        int place = _count;
        while (place > 0 && _slots[place - 1].Time > slot.Time)
            place--;

        bool isDouble = (place > 0 && slot.Time - _slots[place - 1].Time < MinInterval)
            || (place < _count && _slots[place].Time - slot.Time < MinInterval);
        if (isDouble)
        {
            slot.IsDone = true;
            return;
        }

        Array.Copy(_slots, place, _slots, place + 1, _count - place);
        _slots[place] = slot;
        _count++;
    }

    public PoseOrigin Sample(double time, double interval, bool hasSpeed, Span<BoneTransform> pose)
    {
        _interval = interval;
        _hasSpeed = hasSpeed;
        if (_count == 0)
            return PoseOrigin.None;

        int after = 0;
        while (after < _count && _slots[after].Time <= time)
            after++;

        SampledTag = _slots[Math.Max(after - 1, 0)].Tag;
        PoseOrigin origin = PoseOrigin.Interpolated;
        if (after == _count)
            origin = Continue(_count - 1, time, pose);
        else if (after > 0)
            Interpolate(after, time, pose);
        else
            origin = CopyFirst(pose);

        // Cubic interpolation needs two frames before the requested time. One more is kept for a slightly earlier request.
        Forget(after - 3);
        return origin;
    }

    private PoseOrigin CopyFirst(Span<BoneTransform> pose)
    {
        _slots[0].Pose.CopyTo(pose);
        return PoseOrigin.First;
    }

    private void Interpolate(int after, double time, Span<BoneTransform> pose)
    {
        PoseSlot from = _slots[after - 1];
        PoseSlot to = _slots[after];
        if (to.Time - from.Time > Math.Max(GapIntervals * _interval, _delay + _reach))
        {
            CatchUp(after, time, pose);
            return;
        }

        if (!_isCubic)
        {
            PoseInterpolation.Linear(from.Pose, to.Pose, (time - from.Time) / (to.Time - from.Time), pose);
            return;
        }

        PoseSlot? before = after >= 2 ? _slots[after - 2] : null;
        PoseSlot? next = after + 1 < _count ? _slots[after + 1] : null;
        var frames = new CubicPoseWindow
        {
            First = before?.Pose,
            Second = from.Pose,
            Third = to.Pose,
            Fourth = next?.Pose,
            Times = (before?.Time ?? 0, from.Time, to.Time, next?.Time ?? 0),
        };
        PoseInterpolation.Cubic(frames, time, pose);
    }

    // After a long gap, the pose stood still. It moves to the frame that ends the gap within the delay, and therefore does not jump.
    private void CatchUp(int after, double time, Span<BoneTransform> pose)
    {
        double end = _slots[after].Time;
        double start = end - Math.Max(_delay, _interval);
        _ = Continue(after - 1, time, pose);
        if (time <= start)
            return;

        pose[..BoneHierarchy.BoneCount].CopyTo(_held);
        PoseInterpolation.Linear(_held, _slots[after].Pose, (time - start) / (end - start), pose);
    }

    // Continues the motion of the latest two frames beyond them, and slows down steadily to a stop.
    private PoseOrigin Continue(int last, double time, Span<BoneTransform> pose)
    {
        PoseSlot newest = _slots[last];
        double beyond = time - newest.Time;
        double ahead = beyond < _reach ? beyond - (beyond * beyond / (2 * _reach)) : _reach / 2;
        if (_hasSpeed && last > 0 && ahead > 0)
        {
            PoseSlot before = _slots[last - 1];
            double interval = newest.Time - before.Time;

            // A speed across a gap has no meaning.
            if (interval <= Math.Max(GapIntervals * _interval, _delay + _reach))
            {
                PoseInterpolation.Linear(before.Pose, newest.Pose, 1 + (ahead / Math.Max(interval, _interval / 2)), pose);
                return beyond < _reach ? PoseOrigin.Extrapolated : PoseOrigin.Held;
            }
        }

        newest.Pose.CopyTo(pose);
        return PoseOrigin.Held;
    }

    private void Forget(int count)
    {
        if (count <= 0)
            return;

        for (int i = 0; i < count; i++)
            _slots[i].IsDone = true;

        _count -= count;
        Array.Copy(_slots, count, _slots, 0, _count);
    }
}
