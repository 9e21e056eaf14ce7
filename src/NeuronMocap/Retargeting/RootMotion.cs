namespace NeuronMocap.Retargeting;

/// <summary>Specifies which part of the actor's root motion the character follows.</summary>
public enum RootMotion
{
    /// <summary>All of it: horizontal and vertical motion.</summary>
    Full = 0,

    /// <summary>Horizontal motion only. The hips stay at their rest height.</summary>
    Horizontal,

    /// <summary>Vertical motion only. The character crouches and jumps in place.</summary>
    InPlace,
}
