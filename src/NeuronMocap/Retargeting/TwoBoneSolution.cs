using System.Numerics;

namespace NeuronMocap.Retargeting;

/// <summary>The turns of two bones that bring their end to a target, computed by <see cref="TwoBoneIk"/>.</summary>
/// <param name="Upper">The turn of the upper bone, in the axes of the positions. Its new rotation is this turn times the old rotation.</param>
/// <param name="Lower">The turn of the lower bone, likewise. It is the full turn, not an addition to the turn of the upper bone.</param>
/// <param name="Middle">The new position of the joint between the two bones.</param>
/// <param name="End">The new position of the end: the target, or the closest reachable point in the direction of the target.</param>
public readonly record struct TwoBoneSolution(Quaternion Upper, Quaternion Lower, Vector3 Middle, Vector3 End);
