namespace NeuronMocap.Motion;

/// <summary>What a pose that a <see cref="PoseBuffer"/> gives was made of.</summary>
public enum PoseOrigin
{
    /// <summary>Nothing: no frame has come yet, and no pose was written.</summary>
    None,

    /// <summary>The first frame, as it is: the moment is before it.</summary>
    First,

    /// <summary>The frames before and after the moment.</summary>
    Interpolated,

    /// <summary>The newest frames: the motion goes on without a later one, for a short time.</summary>
    Extrapolated,

    /// <summary>The newest frame: none has come for longer than motion is made up, and the pose stands still.</summary>
    Held,
}
