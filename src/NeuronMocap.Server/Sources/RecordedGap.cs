namespace NeuronMocap.Server;

/// <summary>A gap in a recorded take: a place where frames are missing.</summary>
/// <param name="Frame">Number of the first frame of the source after the gap.</param>
/// <param name="Time">Arrival time of that frame, since the start of the recording.</param>
/// <param name="Missing">Number of missing frames according to the server's frame index. Null if the index does not give it.</param>
/// <param name="IsFilled">Whether interpolated frames fill the gap. Otherwise the take continues directly after it.</param>
public readonly record struct RecordedGap(long Frame, TimeSpan Time, long? Missing, bool IsFilled);
