using System.Collections.Immutable;
using System.Numerics;
using NeuronMocap.Motion;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>Finds the times at which the feet are on the ground, in bounded memory: it estimates them in overlapping parts of the take.</summary>
/// <remarks>One thread adds, any thread reads.</remarks>
internal sealed class ContactFinder
{
    // The ground that the estimate assumes rises by 30 cm/s, so what is minutes away has no influence.
    private const int PartSize = 16_384; // frames
    private const int Overlap = 2048;

    private readonly Lock _lock = new();
    private readonly List<Sample> _samples = [];
    private readonly Steps _left = new();
    private readonly Steps _right = new();
    private int _done;

    /// <summary>Adds the next frame.</summary>
    /// <param name="world">59 transforms in the world, centimetres.</param>
    /// <param name="body">The body.</param>
    /// <param name="microseconds">The time of the frame.</param>
    /// <param name="isAfterGap">Whether a gap precedes the frame.</param>
    /// <param name="measured">The contacts that the file holds; null if it has none.</param>
    public void Add(ReadOnlySpan<BoneTransform> world, SkeletonBody body, long microseconds, bool isAfterGap, FootContacts? measured)
    {
        if (isAfterGap)
            Finish();

        _samples.Add(new Sample(microseconds, Middle(world, body, Bone.LeftFoot), Middle(world, body, Bone.RightFoot), measured));
        if (_samples.Count < PartSize + Overlap)
            return;

        Estimate(PartSize);
        int dropped = Math.Max(0, PartSize - Overlap);
        _samples.RemoveRange(0, dropped);
        _done -= dropped;
    }

    /// <summary>Estimates the rest. Frames that follow are independent.</summary>
    public void Finish()
    {
        if (_samples.Count > 0)
            Estimate(_samples.Count);

        _samples.Clear();
        _done = 0;
        lock (_lock)
        {
            _left.End();
            _right.End();
        }
    }

    public (ImmutableArray<TimeStretch> Left, ImmutableArray<TimeStretch> Right) GetContacts()
    {
        lock (_lock)
            return (_left.GetAll(), _right.GetAll());
    }

    // Estimates all samples, and keeps the results of those before the end that are not done.
    private void Estimate(int end)
    {
        FootContacts[] contacts = EstimateAll();
        lock (_lock)
        {
            for (; _done < end; _done++)
            {
                FootContacts now = _samples[_done].Measured ?? contacts[_done];
                _left.Add(_samples[_done].Time, now.Left);
                _right.Add(_samples[_done].Time, now.Right);
            }
        }
    }

    private FootContacts[] EstimateAll()
    {
        if (_samples.TrueForAll(static sample => sample.Measured is not null))
            return new FootContacts[_samples.Count];

        var track = new FootContactTrack();
        foreach (Sample sample in _samples)
            track.Add(sample.Left, sample.Right, sample.Time / 1e6);

        return track.EstimateContacts();
    }

    private static Vector3 Middle(ReadOnlySpan<BoneTransform> world, SkeletonBody body, Bone foot) =>
        (world[(int)foot].Position + world[(int)foot].TransformPoint(body.EndSites[(int)foot])) / 2;

    private readonly record struct Sample(long Time, Vector3 Left, Vector3 Right, FootContacts? Measured);

    private sealed class Steps
    {
        private readonly List<TimeStretch> _steps = [];
        private bool _touches;

        public void Add(long time, bool touches)
        {
            if (_touches)
                _steps[^1] = _steps[^1] with { To = time };
            if (touches && !_touches)
                _steps.Add(new TimeStretch(time, time));

            _touches = touches;
        }

        public void End() => _touches = false;

        public ImmutableArray<TimeStretch> GetAll() => [.. _steps];
    }
}
