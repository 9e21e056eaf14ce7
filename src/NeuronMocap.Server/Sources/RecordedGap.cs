namespace NeuronMocap.Server;

/// <summary>A place of a recorded take where frames are missing.</summary>
/// <param name="Frame">Number of the frame of the source that follows the gap.</param>
/// <param name="Time">When that frame arrived, since the recording's start.</param>
/// <param name="Missing">Frames that the server sent in between, as its frame index tells; null where it does not tell.</param>
/// <param name="IsFilled">Whether interpolated frames stand in the gap; otherwise the take goes on behind it at once.</param>
public readonly record struct RecordedGap(long Frame, TimeSpan Time, long? Missing, bool IsFilled);
