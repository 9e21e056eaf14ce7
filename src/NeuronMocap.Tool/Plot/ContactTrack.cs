using System.Numerics;

namespace NeuronMocap.Tool.Plot;

/// <summary>When a foot was on the ground, and where.</summary>
internal sealed class ContactTrack
{
    private readonly List<Step> _steps = [];
    private long _frames;
    private bool _touches;

    /// <summary>The times on the ground, one after the other.</summary>
    public IReadOnlyList<Step> Steps => _steps;

    /// <summary>The share of the frames, 0 to 1, in which the foot is on the ground.</summary>
    public double Share => _frames == 0 ? 0 : (double)_steps.Sum(static step => step.End - step.Start) / _frames;

    /// <summary>Takes a frame; they come in order.</summary>
    public void Add(long frame, bool touches, Vector3 foot)
    {
        _frames++;
        if (touches && !_touches)
            _steps.Add(new Step(frame, frame + 1, foot));
        else if (touches)
            _steps[^1] = _steps[^1].Extend(foot);

        _touches = touches;
    }

    /// <summary>A time on the ground.</summary>
    /// <param name="Start">First frame.</param>
    /// <param name="End">The frame after the last one.</param>
    /// <param name="Sum">The foot's places, added up.</param>
    internal readonly record struct Step(long Start, long End, Vector3 Sum)
    {
        /// <summary>Where the foot was, in the middle.</summary>
        public Vector3 Place => Sum / (End - Start);

        public Step Extend(Vector3 foot) => new(Start, End + 1, Sum + foot);
    }
}
