namespace NeuronMocap.Server.Sources.Synthetic;

// A foot between two footprints. It stands on a footprint when both are the same.
internal readonly struct FootSwing(int from, int to, float unit)
{
    // Both feet stay on the ground for this part of a step, before the rear foot leaves.
    private const float BothPlanted = 0.04f;

    // Footprints are counted in steps along the path.
    public int From { get; } = from;

    public int To { get; } = to;

    // 0 while the foot is planted, 1 when it lands.
    public float Progress { get; } = Math.Max(0, (unit - BothPlanted) / (1 - BothPlanted));

    // The whole sole is on the ground and does not move. A foot that rolls over its toes counts as lifted.
    public bool IsPlanted => From == To || Progress <= 0;
}
