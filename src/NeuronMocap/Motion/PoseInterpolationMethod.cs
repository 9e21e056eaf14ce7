namespace NeuronMocap.Motion;

/// <summary>How poses between frames are made.</summary>
public enum PoseInterpolationMethod
{
    /// <summary>On a straight line and at a constant turn: <see cref="PoseInterpolation.Linear"/>. The speed jumps at every frame.</summary>
    Linear,

    /// <summary>With a steady speed: <see cref="PoseInterpolation.Cubic"/>.</summary>
    Cubic,
}
