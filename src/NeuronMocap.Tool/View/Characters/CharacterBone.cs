using NeuronMocap.Retargeting;

namespace NeuronMocap.Tool.View.Characters;

/// <summary>A node that a performer moves.</summary>
/// <param name="Node">Index of the node.</param>
/// <param name="Source">The bone of the stream that it follows.</param>
/// <param name="Humanoid">Its Humanoid bone. Null for the bones of the stream that a Humanoid lacks.</param>
internal readonly record struct CharacterBone(int Node, Bone Source, HumanoidBone? Humanoid);
