namespace NeuronMocap.Motion;

/// <summary>Specifies how poses between frames are computed.</summary>
public enum PoseInterpolationMethod
{
    /// <summary>
    /// Along a straight line and at a constant rotation speed: <see cref="PoseInterpolation.Linear"/>. The velocity jumps at every frame.
    /// </summary>
    Linear,

    /// <summary>With a continuous velocity: <see cref="PoseInterpolation.Cubic"/>.</summary>
    Cubic,
}
