namespace NeuronMocap.Retargeting;

/// <summary>Parts of the body, for masks and weights. Every bone belongs to exactly one of nine parts. The other values are unions.</summary>
[Flags]
public enum BodyParts
{
    /// <summary>No part.</summary>
    None = 0,

    /// <summary>The hips, which carry the orientation and position of the whole body.</summary>
    Hips = 1,

    /// <summary>Spine and chest.</summary>
    Spine = 2,

    /// <summary>Neck, head, eyes and jaw.</summary>
    Head = 4,

    /// <summary>Left collar bone, arm and hand, without fingers.</summary>
    LeftArm = 8,

    /// <summary>Right collar bone, arm and hand, without fingers.</summary>
    RightArm = 16,

    /// <summary>Fingers of the left hand.</summary>
    LeftFingers = 32,

    /// <summary>Fingers of the right hand.</summary>
    RightFingers = 64,

    /// <summary>Left leg and foot.</summary>
    LeftLeg = 128,

    /// <summary>Right leg and foot.</summary>
    RightLeg = 256,

    /// <summary>Both arms, without fingers.</summary>
    Arms = LeftArm | RightArm,

    /// <summary>Fingers of both hands.</summary>
    Fingers = LeftFingers | RightFingers,

    /// <summary>Both legs.</summary>
    Legs = LeftLeg | RightLeg,

    /// <summary>Everything above the hips.</summary>
    UpperBody = Spine | Head | Arms | Fingers,

    /// <summary>Every part.</summary>
    All = Hips | UpperBody | Legs,
}
