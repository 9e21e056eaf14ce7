using NeuronMocap.Protocol;

namespace NeuronMocap.Commands;

/// <summary>Name and length of one bone, in the reply to the command <see cref="DataCommandId.BoneSize"/> (protocol.md section 2.4).</summary>
/// <param name="Name">Name on the server, at most 60 bytes of UTF-8.</param>
/// <param name="Length">The length; its unit is not documented.</param>
public readonly record struct BoneSize(string Name, float Length);
