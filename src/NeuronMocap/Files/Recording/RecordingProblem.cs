namespace NeuronMocap.Recording;

/// <summary>Describes a defect of a recording file.</summary>
/// <param name="Offset">The position in the file, in bytes.</param>
/// <param name="Length">
/// Number of bytes that could not be used; 0 if a block is missing, displaced or duplicate, or if too many connections are open.
/// </param>
/// <param name="Description">The defect, in English.</param>
public readonly record struct RecordingProblem(long Offset, long Length, string Description);
