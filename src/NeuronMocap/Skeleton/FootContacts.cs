namespace NeuronMocap;

/// <summary>Says which feet touch the ground.</summary>
/// <param name="Left">Whether the left foot touches the ground.</param>
/// <param name="Right">Whether the right foot touches the ground.</param>
public readonly record struct FootContacts(bool Left, bool Right);
