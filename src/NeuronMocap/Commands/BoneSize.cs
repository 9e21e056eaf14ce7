using NeuronMocap.Protocol;

namespace NeuronMocap.Commands;

/// <summary>Name and length of one bone, as the command <see cref="DataCommandId.BoneSize"/> tells them (protocol.md section 2.4).</summary>
/// <param name="Name">Name on the server, at most 60 bytes of UTF-8.</param>
/// <param name="Length">The length; nobody has documented its unit.</param>
public readonly record struct BoneSize(string Name, float Length);
