using System.Numerics;

namespace NeuronMocap.Motion;

/// <summary>How a bone moves, in the axes that its transforms are given in.</summary>
/// <param name="Linear">Centimetres per second.</param>
/// <param name="Angular">Radians per second about each axis; the length is the speed, the direction the axis, right-handed.</param>
public readonly record struct BoneVelocity(Vector3 Linear, Vector3 Angular);
