namespace NeuronMocap.Recording;

/// <summary>Something about a file that is not as a recorder writes it.</summary>
/// <param name="Offset">Where in the file, in bytes.</param>
/// <param name="Length">How many bytes of the file could not be used; 0 where a block is missing, displaced or doubled, or too much is open.</param>
/// <param name="Description">What is wrong, for people.</param>
public readonly record struct RecordingProblem(long Offset, long Length, string Description);
