using System.Numerics;

namespace NeuronMocap.Motion;

/// <summary>The velocity of a bone, in the axes of its transforms.</summary>
/// <param name="Linear">The linear velocity in centimetres per second.</param>
/// <param name="Angular">
/// The angular velocity in radians per second about each axis. The length is the speed, and the direction is the right-handed axis.
/// </param>
public readonly record struct BoneVelocity(Vector3 Linear, Vector3 Angular);
