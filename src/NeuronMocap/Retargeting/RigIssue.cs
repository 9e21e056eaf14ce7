namespace NeuronMocap.Retargeting;

/// <summary>A problem of a rig that affects retargeting, found by <see cref="RigValidator"/>.</summary>
/// <param name="Fault">The kind of problem.</param>
/// <param name="Severity">Whether the character can move nevertheless.</param>
/// <param name="Bone">The bone, or the first bone of the limb. Null for the rig as a whole.</param>
/// <param name="Degrees">The deviation in degrees, for faults that are angles. Otherwise 0.</param>
/// <param name="Message">
/// A message for the author of the rig: what is wrong, its visible effect, and the remedy. One or two English sentences.
/// </param>
/// <param name="CanFix">Whether <see cref="TPose.Enforce"/> corrects it.</param>
public sealed record RigIssue(RigFault Fault, RigSeverity Severity, HumanoidBone? Bone, float Degrees, string Message, bool CanFix);

/// <summary>Specifies how much a <see cref="RigIssue"/> matters.</summary>
public enum RigSeverity
{
    /// <summary>The rig works. The note may explain an odd look.</summary>
    Note,

    /// <summary>The character moves, but not correctly.</summary>
    Warning,

    /// <summary>The character cannot move, or Unity cannot create a Humanoid avatar from the rig.</summary>
    Error,
}

/// <summary>The kinds of <see cref="RigIssue"/>.</summary>
public enum RigFault
{
    /// <summary>A required bone has no node.</summary>
    MissingBone,

    /// <summary>Two bones have the same node.</summary>
    DuplicateMapping,

    /// <summary>The node of a bone is not a descendant of the node of its parent bone, or not of the node of the hips.</summary>
    InvalidHierarchy,

    /// <summary>Two nodes have the same name. Unity's avatar builder cannot distinguish them.</summary>
    DuplicateName,

    /// <summary>A position, rotation or scale is not a finite number, or a rotation or scale is zero.</summary>
    InvalidTransform,

    /// <summary>The left and right bones of a limb are swapped.</summary>
    SidesSwapped,

    /// <summary>The character does not stand upright.</summary>
    NotUpright,

    /// <summary>The character does not face +Z.</summary>
    NotFacingForward,

    /// <summary>A limb does not point in its T-pose direction.</summary>
    NotInTPose,

    /// <summary>The palm of a hand does not face down.</summary>
    PalmNotDown,

    /// <summary>A joint is at the same place as the next one.</summary>
    ZeroLengthBone,

    /// <summary>The node above the hips is rotated, as many exporters leave it. Retargeting handles it.</summary>
    RootRotated,

    /// <summary>A node above the hips or one of the bones has a scale that is not 1.</summary>
    Scaled,

    /// <summary>The soles are not at the height of the rig's origin, which is the ground.</summary>
    NotOnGround,
}
