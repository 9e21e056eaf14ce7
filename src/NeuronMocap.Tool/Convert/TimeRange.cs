using NeuronMocap.Server;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Convert;

/// <summary>The requested part of a file, in seconds since its start.</summary>
/// <param name="From">Start; null for the start of the file.</param>
/// <param name="To">End, exclusive; null for the end of the file.</param>
internal readonly record struct TimeRange(double? From, double? To)
{
    // A frame at the edge is assigned by its exact time, not by its rounded time.
    private const double Tolerance = 1e-6;

    public bool IsAll => From is null && To is null;

    public TimeSpan Start => TimeSpan.FromSeconds(From ?? 0);

    public bool Contains(TimeSpan time) => time >= Start && (To is not { } end || time < TimeSpan.FromSeconds(end));

    /// <summary>The reason if the range has no frame.</summary>
    /// <param name="end">The end of the take.</param>
    public static NeuronException NoFrames(TimeSpan end) => new(Quantity.Format($"No frames remain: the take ends at {end.TotalSeconds:0.###} s."));

    /// <summary>Gets the frames of a take in the range. Frames of a recording have their times of arrival.</summary>
    /// <param name="take">A take that has an end.</param>
    /// <returns>The first frame and the number of frames.</returns>
    /// <exception cref="NeuronException">The range has no frame.</exception>
    public (long First, long Count) FramesOf(MotionSource take)
    {
        if (IsAll || take is not RecordingSource recording)
            return FramesOf(take.FrameCount!.Value, take.FrameRate);

        (long first, long end) = (0, recording.FrameCount!.Value);
        while (first < end && !Contains(recording.GetTime(first)))
            first++;
        if (first == end)
            throw NoFrames(recording.GetTime(end - 1));

        while (!Contains(recording.GetTime(end - 1)))
            end--;

        return (first, end - first);
    }

    /// <summary>Gets the frames in the range, for a take at an even rate.</summary>
    /// <param name="count">Number of frames of the take.</param>
    /// <param name="rate">Frames per second.</param>
    /// <returns>The first frame and the number of frames.</returns>
    /// <exception cref="NeuronException">The range has no frame.</exception>
    public (long First, long Count) FramesOf(long count, double rate)
    {
        long first = From is { } from ? (long)Math.Ceiling((from * rate) - Tolerance) : 0;
        long end = To is { } to ? Math.Min(count, (long)Math.Ceiling((to * rate) - Tolerance)) : count;
        return first < end
            ? (first, end - first)
            : throw NoFrames(TimeSpan.FromSeconds(count / rate));
    }
}
