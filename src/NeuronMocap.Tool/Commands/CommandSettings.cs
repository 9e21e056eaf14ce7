using System.Net;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Commands;

/// <summary>The commands that can be sent to a command channel.</summary>
internal enum CommandQuestion
{
    /// <summary>Rotation order, bone sizes and header.</summary>
    All,

    /// <summary>The rotation order.</summary>
    Order,

    /// <summary>The sizes of an avatar's body.</summary>
    Bones,

    /// <summary>An avatar's BVH header.</summary>
    Header,

    /// <summary>Zero out.</summary>
    ZeroOut,
}

/// <summary>Settings of the verb command.</summary>
/// <param name="Server">Address of the command channel; null for the simulator inside this process.</param>
/// <param name="Question">The command to send.</param>
/// <param name="Avatar">Index of the avatar. Null means the first avatar, or all avatars for zero out.</param>
/// <param name="Json">Whether to print the answer as JSON.</param>
internal sealed record CommandSettings(ServerAddress? Server, CommandQuestion Question, int? Avatar, bool Json)
{
    /// <summary>Address of this computer to connect from; null for the system's choice.</summary>
    public IPAddress? LocalAddress { get; init; }
}

/// <summary>The answers of a command channel.</summary>
/// <param name="Server">Address of the command channel.</param>
/// <param name="Avatar">Index of the avatar.</param>
internal sealed record CommandResults(ServerAddress Server, int Avatar)
{
    /// <summary>The rotation order; null if it was not requested.</summary>
    public RotationOrder? Order { get; init; }

    /// <summary>The sizes of the avatar's body; null if they were not requested.</summary>
    public BoneDimensions? Sizes { get; init; }

    /// <summary>The avatar's BVH header; null if it was not requested.</summary>
    public string? Header { get; init; }
}
