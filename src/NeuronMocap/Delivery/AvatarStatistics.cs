using System.Diagnostics;

namespace NeuronMocap;

/// <summary>
/// What arrived of one kind of frame of one avatar of one sender, at the moment of asking. A reader keeps 1,024 of these; one that got no frame
/// for 5 s then makes room for a new one, and begins at 0 when it comes back.
/// </summary>
public readonly record struct AvatarStatistics
{
    /// <summary><see cref="PacketKind.Motion"/>, <see cref="PacketKind.Calculation"/> or <see cref="PacketKind.StudioCalculation"/>.</summary>
    public PacketKind Kind { get; init; }

    /// <summary>Which sender: see <see cref="AvatarFrame.Sender"/>.</summary>
    public int Sender { get; init; }

    /// <summary>Number of the avatar on the server.</summary>
    public int AvatarIndex { get; init; }

    /// <summary>Name of the avatar, as its newest frame has it.</summary>
    public string AvatarName { get; init; }

    /// <summary>Frames received.</summary>
    public long Frames { get; init; }

    /// <summary>
    /// Frames that the server sent and that did not arrive, as the frame index tells; always 0 for headers without one. In steps of
    /// <see cref="FrequencyReduction"/>: what the server leaves out on purpose is not lost. Falls again when a lost frame comes late, and when
    /// the first 16 steps of a reduced frequency turn out to be even.
    /// </summary>
    public long Lost { get; init; }

    /// <summary>Number of gaps: rows of one or more lost frames with frames before and after.</summary>
    public long Gaps { get; init; }

    /// <summary>Frames that came twice or after a later one.</summary>
    public long OutOfOrder { get; init; }

    /// <summary>How often the server began to count anew within a connection: a jump back by more than 63, ahead by more than 10,000, or three even steps from further back.</summary>
    public long Restarts { get; init; }

    /// <summary>
    /// By how much the frame index grows from frame to frame: 1 at the full rate, 2 when the server sends every second frame (Axis Neuron's
    /// frequency reducing), at most 60. Known after 16 frames of even steps; a smaller one at once. Every second frame lost as by clockwork
    /// looks the same.
    /// </summary>
    public int FrequencyReduction { get; init; }

    /// <summary>Frames per second, as a running mean over about the last 64 frames; 0 until there are two. It stays as it was when frames cease: see <see cref="LastTimestamp"/>.</summary>
    public double FrameRate { get; init; }

    /// <summary>Standard deviation of the time between frames, over about the last 64.</summary>
    public TimeSpan Jitter { get; init; }

    /// <summary>When the newest frame was received: ticks of <see cref="Stopwatch"/>.</summary>
    public long LastTimestamp { get; init; }

    /// <summary>How old the newest frame is: a stale avatar is one whose age grows beyond a few intervals.</summary>
    /// <param name="timestamp">Now: ticks of <see cref="Stopwatch"/>.</param>
    /// <returns>Time since the newest frame was received; zero when that was later than the given moment.</returns>
    public TimeSpan GetAge(long timestamp) =>
        TimeSpan.FromSeconds(Math.Max(timestamp - LastTimestamp, 0) / (double)Stopwatch.Frequency);
}
