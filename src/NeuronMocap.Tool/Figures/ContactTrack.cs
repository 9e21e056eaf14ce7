using System.Numerics;

namespace NeuronMocap.Tool.Figures;

/// <summary>The times and places at which a foot is on the ground.</summary>
internal sealed class ContactTrack
{
    private readonly List<Step> _steps = [];
    private long _frames;
    private bool _touches;

    /// <summary>The times on the ground, in order.</summary>
    public IReadOnlyList<Step> Steps => _steps;

    /// <summary>The share of the frames, 0 to 1, in which the foot is on the ground.</summary>
    public double Share => _frames == 0 ? 0 : (double)_steps.Sum(static step => step.End - step.Start) / _frames;

    /// <summary>Adds a frame. Frames must be added in order.</summary>
    public void Add(long frame, bool touches, Vector3 foot)
    {
        _frames++;
        if (touches && !_touches)
            _steps.Add(new Step(frame, frame + 1, foot));
        else if (touches)
            _steps[^1] = _steps[^1].Extend(foot);

        _touches = touches;
    }

    /// <summary>A period on the ground.</summary>
    /// <param name="Start">First frame.</param>
    /// <param name="End">The frame after the last one.</param>
    /// <param name="Sum">Sum of the foot's positions.</param>
    internal readonly record struct Step(long Start, long End, Vector3 Sum)
    {
        /// <summary>Mean position of the foot.</summary>
        public Vector3 Place => Sum / (End - Start);

        public Step Extend(Vector3 foot) => new(Start, End + 1, Sum + foot);
    }
}
