namespace NeuronMocap.Diagnostics;

/// <summary>What arrived of one kind of frame of one avatar while a diagnosis looked.</summary>
public sealed record DiagnosedAvatar
{
    /// <summary><see cref="PacketKind.Motion"/>, <see cref="PacketKind.Calculation"/> or <see cref="PacketKind.StudioCalculation"/>.</summary>
    public PacketKind Kind { get; init; }

    /// <summary>Number of the avatar on the server, as its 32 bits are.</summary>
    public int Index { get; init; }

    /// <summary>Name of the avatar.</summary>
    public string Name { get; init; } = string.Empty;

    /// <summary>Data version of its newest frame; <see cref="DataVersion.None"/> when it came as text.</summary>
    public DataVersion Version { get; init; }

    /// <summary>Values of its newest frame.</summary>
    public int ValueCount { get; init; }

    /// <summary>Whether every bone carries a position; false for calculation frames, which do not have the setting.</summary>
    public bool HasDisplacement { get; init; }

    /// <summary>Whether the Reference node comes first; false for calculation frames, which do not have the setting.</summary>
    public bool HasReference { get; init; }

    /// <summary>Frames that arrived.</summary>
    public long Frames { get; init; }

    /// <summary>Frames that the server counted and that did not arrive; 0 for headers without a frame index.</summary>
    public long Lost { get; init; }

    /// <summary>Frames per second; 0 when too few arrived to tell.</summary>
    public double FrameRate { get; init; }

    /// <summary>Longest time between two frames.</summary>
    public TimeSpan LongestGap { get; init; }
}
