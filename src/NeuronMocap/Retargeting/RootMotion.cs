namespace NeuronMocap.Retargeting;

/// <summary>Which of the actor's ways the character goes too.</summary>
public enum RootMotion
{
    /// <summary>All: over the ground, up and down.</summary>
    Full = 0,

    /// <summary>Over the ground only; the hips stay as high as at rest.</summary>
    Horizontal,

    /// <summary>Up and down only: the character crouches and jumps where it stands.</summary>
    InPlace,
}
