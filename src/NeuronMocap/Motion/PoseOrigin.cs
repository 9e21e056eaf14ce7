namespace NeuronMocap.Motion;

/// <summary>Specifies from which frames a <see cref="PoseBuffer"/> computed a pose.</summary>
public enum PoseOrigin
{
    /// <summary>No frame has arrived yet, and no pose was written.</summary>
    None,

    /// <summary>The first frame, unchanged. The requested time is before it.</summary>
    First,

    /// <summary>The frames before and after the requested time.</summary>
    Interpolated,

    /// <summary>The latest frames. No later frame has arrived, and the motion continues for a short time.</summary>
    Extrapolated,

    /// <summary>The latest frame. No frame has arrived for longer than the motion continues, and the pose stands still.</summary>
    Held,
}
