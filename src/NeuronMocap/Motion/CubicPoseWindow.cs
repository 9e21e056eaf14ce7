namespace NeuronMocap.Motion;

/// <summary>Four consecutive frames and their times, in seconds on any clock: the input of <see cref="PoseInterpolation.Cubic"/>.</summary>
public readonly ref struct CubicPoseWindow
{
    /// <summary>The second frame before the requested time; empty if it does not exist.</summary>
    public ReadOnlySpan<BoneTransform> First { get; init; }

    /// <summary>The frame before the requested time.</summary>
    public ReadOnlySpan<BoneTransform> Second { get; init; }

    /// <summary>The frame after the requested time.</summary>
    public ReadOnlySpan<BoneTransform> Third { get; init; }

    /// <summary>The second frame after the requested time; empty if it does not exist.</summary>
    public ReadOnlySpan<BoneTransform> Fourth { get; init; }

    /// <summary>The times of the four frames, in ascending order. The times of empty frames have no meaning.</summary>
    public (double First, double Second, double Third, double Fourth) Times { get; init; }
}
