namespace NeuronMocap.Motion;

/// <summary>Four frames in a row and when each was, in seconds on any clock: what <see cref="PoseInterpolation.Cubic"/> needs.</summary>
public readonly ref struct CubicPoseWindow
{
    /// <summary>Two frames before the moment that is asked for; empty where there is none.</summary>
    public ReadOnlySpan<BoneTransform> First { get; init; }

    /// <summary>The frame before the moment that is asked for.</summary>
    public ReadOnlySpan<BoneTransform> Second { get; init; }

    /// <summary>The frame after it.</summary>
    public ReadOnlySpan<BoneTransform> Third { get; init; }

    /// <summary>The frame after that; empty where there is none.</summary>
    public ReadOnlySpan<BoneTransform> Fourth { get; init; }

    /// <summary>The times of the four, each later than the one before; those of empty ones have no meaning.</summary>
    public (double First, double Second, double Third, double Fourth) Times { get; init; }
}
