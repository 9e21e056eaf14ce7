namespace NeuronMocap;

/// <summary>Which feet stand on the ground.</summary>
/// <param name="Left">Whether the left one does.</param>
/// <param name="Right">Whether the right one does.</param>
public readonly record struct FootContacts(bool Left, bool Right);
