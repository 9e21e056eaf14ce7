namespace NeuronMocap.Calculation;

/// <summary>Specifies where an axis of the world points, for an actor who faces forward.</summary>
public enum BodyDirection
{
    /// <summary>To the actor's left: X of BVH.</summary>
    Left,

    /// <summary>To the actor's right.</summary>
    Right,

    /// <summary>Away from the ground: Y of BVH.</summary>
    Up,

    /// <summary>Into the ground.</summary>
    Down,

    /// <summary>The direction that the actor faces: Z of BVH.</summary>
    Forward,

    /// <summary>Opposite to the direction that the actor faces.</summary>
    Backward,
}
