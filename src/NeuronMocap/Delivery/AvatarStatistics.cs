using System.Diagnostics;
using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

/// <summary>What arrived of one kind of frame of one avatar of one sender, at the moment of asking.</summary>
public readonly record struct AvatarStatistics
{
    /// <summary><see cref="PacketKind.Motion"/> or <see cref="PacketKind.Calculation"/>.</summary>
    public PacketKind Kind { get; init; }

    /// <summary>Which sender: see <see cref="Frames.AvatarFrame.Source"/>.</summary>
    public int Source { get; init; }

    /// <summary>Number of the avatar on the server.</summary>
    public int AvatarIndex { get; init; }

    /// <summary>Name of the avatar, as its newest frame has it.</summary>
    public string AvatarName { get; init; }

    /// <summary>Frames received.</summary>
    public long Frames { get; init; }

    /// <summary>Frames that the server counted and that did not arrive; always 0 for headers without a frame index.</summary>
    public long Lost { get; init; }

    /// <summary>Frames that came twice or after a later one.</summary>
    public long Disordered { get; init; }

    /// <summary>Frames per second, as a running mean over about the last 64 frames; 0 until there are two. It stays as it was when frames cease: see <see cref="LastTimestamp"/>.</summary>
    public double Rate { get; init; }

    /// <summary>Standard deviation of the time between frames, over about the last 64.</summary>
    public TimeSpan Jitter { get; init; }

    /// <summary>When the newest frame was received: ticks of <see cref="Stopwatch"/>.</summary>
    public long LastTimestamp { get; init; }
}
