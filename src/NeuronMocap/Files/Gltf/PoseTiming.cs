using NeuronMocap.Motion;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Gltf;

// Brings frames to the times of the keys: holds the pose in gaps, and interpolates keys at an even rate.
internal sealed class PoseTiming(PoseAnimation animation, double? rate)
{
    // A longer distance between two frames is a gap if it is also longer than usual.
    private const double LongestStep = 1;
    private const double UnusualStep = 4;

    // In seconds. Times of frames are rounded to 100 ns.
    private const double SameTime = 1e-6;

    private readonly BoneTransform[] _before = new BoneTransform[BoneHierarchy.BoneCount];
    private readonly BoneTransform[] _between = new BoneTransform[BoneHierarchy.BoneCount];
    private double _start;
    private double _time = double.NegativeInfinity;
    private double _step = double.PositiveInfinity;
    private double _nextKey;

    // Returns false if the frame is left out because its time does not advance.
    public bool Add(double seconds, ReadOnlySpan<BoneTransform> pose)
    {
        if (seconds <= _time)
            return false;

        bool isFirst = double.IsNegativeInfinity(_time);
        if (isFirst)
            _start = seconds;

        double step = seconds - _time;
        bool isGap = !isFirst && step > LongestStep && step > UnusualStep * _step;
        if (isGap)
        {
            // The figure keeps its pose until a usual step before the next frame, instead of moving slowly for the length of the gap.
            double held = seconds - _step;
            Pass(held, _before, isHeld: true);
            _time = held;
        }

        if (!Pass(seconds, pose, isHeld: false))
            return false;

        if (!isFirst && !isGap)
            _step = step;

        _time = seconds;
        pose[.._before.Length].CopyTo(_before);
        return true;
    }

    private bool Pass(double seconds, ReadOnlySpan<BoneTransform> pose, bool isHeld)
    {
        if (rate is not { } keys)
            return animation.Add(seconds, pose);

        // Of a held pose, the first and the last key suffice.
        double last = Math.Floor(((seconds - _start) + SameTime) * keys);
        if (isHeld && last - _nextKey > 1)
        {
            AddKey(_nextKey / keys, seconds, pose);
            _nextKey = last;
        }

        for (; _nextKey <= last; _nextKey++)
            AddKey(_nextKey / keys, seconds, pose);

        return true;
    }

    private void AddKey(double sinceStart, double seconds, ReadOnlySpan<BoneTransform> pose)
    {
        double time = _start + sinceStart;
        double part = (time - _time) / (seconds - _time);
        if (seconds - time <= SameTime || double.IsNegativeInfinity(_time))
        {
            animation.Add(time, pose);
            return;
        }

        PoseInterpolation.Linear(_before, pose, time - _time <= SameTime ? 0 : part, _between);
        animation.Add(time, _between);
    }
}
