using System.Diagnostics;

namespace NeuronMocap;

/// <summary>A snapshot of the statistics of one kind of frame, of one avatar, of one sender.</summary>
/// <remarks>
/// A reader keeps 1,024 of these, and beyond them up to 16 of each sender over UDP: 2,048 at most. To make room for a new one, it removes one that got no
/// frame for 5 s. An avatar that returns after that starts again at 0.
/// </remarks>
public readonly record struct AvatarStatistics
{
    /// <summary><see cref="PacketKind.Motion"/>, <see cref="PacketKind.Calculation"/> or <see cref="PacketKind.StudioCalculation"/>.</summary>
    public PacketKind Kind { get; init; }

    /// <summary>Number of the sender: see <see cref="AvatarFrame.Sender"/>.</summary>
    public int Sender { get; init; }

    /// <summary>Number of the avatar on the server.</summary>
    public int AvatarIndex { get; init; }

    /// <summary>Name of the avatar in its newest frame.</summary>
    public string AvatarName { get; init; }

    /// <summary>Frames received.</summary>
    public long Frames { get; init; }

    /// <summary>
    /// Number of frames that the server sent but that did not arrive, according to the frame index; always 0 if the header has no index.
    /// </summary>
    /// <remarks>
    /// The count considers <see cref="FrequencyReduction"/>: frames that the server leaves out on purpose are not lost. The count decreases when a lost
    /// frame arrives late. It also decreases when the first 16 steps of a reduced frequency turn out to be even.
    /// </remarks>
    public long Lost { get; init; }

    /// <summary>Number of gaps: runs of one or more lost frames between received frames.</summary>
    public long Gaps { get; init; }

    /// <summary>Number of frames that arrived twice, or after a later frame.</summary>
    public long OutOfOrder { get; init; }

    /// <summary>
    /// How often the server restarted its count within a connection. A restart is a jump back by more than 63, a jump ahead by more than 10,000, or three
    /// even steps from an earlier index.
    /// </summary>
    public long Restarts { get; init; }

    /// <summary>
    /// The step of the frame index from frame to frame, 1 to 60. It is 1 at the full rate, and 2 if the server sends every second frame
    /// (Axis Neuron's frequency reduction).
    /// </summary>
    /// <remarks>
    /// A larger step is known after 16 even steps, a smaller step at once. A regular loss of every second frame looks the same as a reduced frequency.
    /// </remarks>
    public int FrequencyReduction { get; init; }

    /// <summary>
    /// Frames per second: a running mean over about the last 64 frames, or 0 until there are two. When frames stop, it keeps its value: see
    /// <see cref="LastTimestamp"/>.
    /// </summary>
    public double FrameRate { get; init; }

    /// <summary>Standard deviation of the time between frames, over about the last 64 frames.</summary>
    public TimeSpan Jitter { get; init; }

    /// <summary>When the newest frame was received, in ticks of <see cref="Stopwatch"/>.</summary>
    public long LastTimestamp { get; init; }

    /// <summary>Gets the age of the newest frame. An avatar is stale when this age exceeds a few frame intervals.</summary>
    /// <param name="timestamp">The current time, in ticks of <see cref="Stopwatch"/>.</param>
    /// <returns>Time since the newest frame was received; zero if the given time is earlier.</returns>
    public TimeSpan GetAge(long timestamp) =>
        PreciseTime.FromSeconds(Math.Max(timestamp - LastTimestamp, 0) / (double)Stopwatch.Frequency);
}
