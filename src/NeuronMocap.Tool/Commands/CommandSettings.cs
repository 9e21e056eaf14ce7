using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Commands;

/// <summary>What to ask of a command channel.</summary>
internal enum CommandQuestion
{
    /// <summary>Order, bones and header.</summary>
    All,

    /// <summary>The rotation order.</summary>
    Order,

    /// <summary>The sizes of an avatar's body.</summary>
    Bones,

    /// <summary>An avatar's BVH header.</summary>
    Header,

    /// <summary>To zero out.</summary>
    ZeroOut,
}

/// <summary>What the command line asks of a command channel.</summary>
/// <param name="Server">Where it is; null for the simulator inside this process.</param>
/// <param name="Question">What to ask.</param>
/// <param name="Avatar">Index of the avatar that the question is about; null for the first, and for all of them to zero out.</param>
/// <param name="Json">Whether the answer is for a program.</param>
internal sealed record CommandSettings(ServerAddress? Server, CommandQuestion Question, int? Avatar, bool Json);

/// <summary>What a command channel answered.</summary>
/// <param name="Server">Where it is.</param>
/// <param name="Avatar">Index of the avatar.</param>
internal sealed record CommandResults(ServerAddress Server, int Avatar)
{
    /// <summary>The rotation order; null where nobody asked.</summary>
    public RotationOrder? Order { get; init; }

    /// <summary>The sizes of the avatar's body; null where nobody asked.</summary>
    public BoneDimensions? Sizes { get; init; }

    /// <summary>The avatar's BVH header; null where nobody asked.</summary>
    public string? Header { get; init; }
}
