namespace NeuronMocap.Diagnostics;

/// <summary>The frames of one kind of one avatar that arrived during a diagnosis.</summary>
public sealed record DiagnosedAvatar
{
    /// <summary><see cref="PacketKind.Motion"/>, <see cref="PacketKind.Calculation"/> or <see cref="PacketKind.StudioCalculation"/>.</summary>
    public PacketKind Kind { get; init; }

    /// <summary>Number of the avatar on the server; its 32 bits are interpreted as a signed number.</summary>
    public int Index { get; init; }

    /// <summary>Name of the avatar.</summary>
    public string Name { get; init; } = string.Empty;

    /// <summary>Data version of its newest frame; <see cref="DataVersion.None"/> when it came as text.</summary>
    public DataVersion Version { get; init; }

    /// <summary>Number of values in its newest frame.</summary>
    public int ValueCount { get; init; }

    /// <summary>Whether every bone has a position. False for calculation frames, which do not have this setting.</summary>
    public bool HasDisplacement { get; init; }

    /// <summary>Whether the Reference node comes first. False for calculation frames, which do not have this setting.</summary>
    public bool HasReference { get; init; }

    /// <summary>Number of frames that arrived.</summary>
    public long Frames { get; init; }

    /// <summary>Number of frames that the server counted but that did not arrive; 0 for headers without a frame index.</summary>
    public long Lost { get; init; }

    /// <summary>Frames per second; 0 if too few frames arrived to measure it.</summary>
    public double FrameRate { get; init; }

    /// <summary>Longest time between two frames.</summary>
    public TimeSpan LongestGap { get; init; }
}
