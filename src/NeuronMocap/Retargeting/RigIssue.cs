namespace NeuronMocap.Retargeting;

/// <summary>Something about a rig that retargeting cannot or should not live with, as <see cref="RigValidator"/> found it.</summary>
/// <param name="Fault">What kind of thing.</param>
/// <param name="Severity">Whether the figure can move nevertheless.</param>
/// <param name="Bone">The bone, or the first of the limb; null when it is the rig as a whole.</param>
/// <param name="Degrees">How far off, for faults that are angles; otherwise 0.</param>
/// <param name="Message">For whoever made the rig: what is wrong, what will be seen of it, and what to do. One or two English sentences.</param>
/// <param name="CanFix">Whether <see cref="TPose.Enforce"/> makes it right.</param>
public sealed record RigIssue(RigFault Fault, RigSeverity Severity, HumanoidBone? Bone, float Degrees, string Message, bool CanFix);

/// <summary>How much a <see cref="RigIssue"/> matters.</summary>
public enum RigSeverity
{
    /// <summary>Works; good to know when something looks odd.</summary>
    Note,

    /// <summary>The figure moves, and not as it should.</summary>
    Warning,

    /// <summary>The figure cannot move, or Unity makes no Humanoid of it.</summary>
    Error,
}

/// <summary>The kinds of <see cref="RigIssue"/>.</summary>
public enum RigFault
{
    /// <summary>A required bone has no node.</summary>
    MissingBone,

    /// <summary>Two bones have the same node.</summary>
    DuplicateMapping,

    /// <summary>A bone's node does not hang, directly or not, from the node of the bone that it belongs to.</summary>
    InvalidHierarchy,

    /// <summary>Two nodes have the same name, which Unity's avatar builder cannot tell apart.</summary>
    DuplicateName,

    /// <summary>A position, rotation or scale is not a finite number, or a rotation or scale is zero.</summary>
    InvalidTransform,

    /// <summary>A limb's bones of the left are on the right and the other way round.</summary>
    SidesSwapped,

    /// <summary>The figure does not stand upright.</summary>
    NotUpright,

    /// <summary>The figure does not look along +Z.</summary>
    NotFacingForward,

    /// <summary>A limb does not point where it does in a T-pose.</summary>
    NotInTPose,

    /// <summary>A hand's palm does not look down.</summary>
    PalmNotDown,

    /// <summary>A joint lies on the next one.</summary>
    ZeroLengthBone,

    /// <summary>The node above the hips is turned, as many exporters leave it. Retargeting takes care of it.</summary>
    RootRotated,

    /// <summary>A node above the hips or one of the bones has a scale that is not 1.</summary>
    Scaled,

    /// <summary>The soles are not at the height of the rig's origin, where the ground is.</summary>
    NotOnGround,
}
