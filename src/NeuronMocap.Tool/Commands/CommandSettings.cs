using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Commands;

/// <summary>What to ask of a command channel.</summary>
/// <param name="Server">Where it is; null for the simulator inside this process.</param>
/// <param name="Avatar">Index of the avatar that the questions are about.</param>
/// <param name="ZeroOut">Whom to zero out instead of asking; null for nobody.</param>
/// <param name="WholeHeader">Whether to print the BVH header as it is.</param>
internal sealed record CommandSettings(ServerAddress? Server, int Avatar, ZeroOutTarget? ZeroOut, bool WholeHeader);

/// <summary>One avatar or all.</summary>
/// <param name="Avatar">Its index; null for all.</param>
internal readonly record struct ZeroOutTarget(int? Avatar);
