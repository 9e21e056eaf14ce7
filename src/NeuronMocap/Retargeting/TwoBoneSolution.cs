using System.Numerics;

namespace NeuronMocap.Retargeting;

/// <summary>How two bones turn so that their end comes to a target, as <see cref="TwoBoneIk"/> finds it.</summary>
/// <param name="Upper">What the upper bone turns by, in the axes of the positions: its new rotation is this times the old one.</param>
/// <param name="Lower">What the lower bone turns by, likewise: the whole turn, not what it adds to that of the upper one.</param>
/// <param name="Middle">Where the joint between the two bones comes to.</param>
/// <param name="End">Where the end comes to: the target, or the reachable point that is next to it in the direction of the target.</param>
public readonly record struct TwoBoneSolution(Quaternion Upper, Quaternion Lower, Vector3 Middle, Vector3 End);
