namespace NeuronMocap.Calculation;

/// <summary>Where an axis of the world points, for an actor who faces forward.</summary>
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

    /// <summary>Where the actor faces: Z of BVH.</summary>
    Forward,

    /// <summary>Away from where the actor faces.</summary>
    Backward,
}
