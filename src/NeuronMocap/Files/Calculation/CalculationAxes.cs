using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Calculation;

/// <summary>
/// Represents the world axes of calculation data, which are a setting of the server, and converts between them and the axes of BVH. Immutable;
/// thread-safe.
/// </summary>
/// <remarks>
/// The axes of BVH are right-handed: Y up, X to the actor's left, Z forward. The axes of sensors are converted in the same way. The identity
/// rotation therefore stays the identity.
/// </remarks>
public sealed class CalculationAxes
{
    /// <summary>Number of centimetres, the unit of BVH, in a metre, the unit of calculation data.</summary>
    public const float CentimetresPerMetre = 100;

    private const int ValuesPerBone = 16;
    private const int ContactCount = 2;

    private readonly Vector3 _x;
    private readonly Vector3 _y;
    private readonly Vector3 _z;
    private readonly float _handedness;

    /// <summary>Creates axes.</summary>
    /// <param name="x">The direction of x.</param>
    /// <param name="y">The direction of y.</param>
    /// <param name="z">The direction of z.</param>
    /// <exception cref="ArgumentException">Two of the axes are parallel.</exception>
    public CalculationAxes(BodyDirection x, BodyDirection y, BodyDirection z)
    {
        (X, Y, Z) = (x, y, z);
        (_x, _y, _z) = (Direct(x), Direct(y), Direct(z));
        _handedness = Vector3.Dot(Vector3.Cross(_x, _y), _z);
        if (_handedness == 0)
            throw new ArgumentException("The three axes must be perpendicular to each other.", nameof(z));
    }

    /// <summary>
    /// The axes of exported files: right-handed, with z into the ground.
    /// </summary>
    /// <remarks>
    /// x and y lie in the ground plane, and actors may face any direction. By convention, x points to the left of an actor who faces forward in
    /// BVH. This choice only turns a take about the vertical. The evidence is in docs/guide/calculation.md.
    /// </remarks>
    public static CalculationAxes Export { get; } = new(BodyDirection.Left, BodyDirection.Forward, BodyDirection.Down);

    /// <summary>The axes of BVH.</summary>
    public static CalculationAxes Bvh { get; } = new(BodyDirection.Left, BodyDirection.Up, BodyDirection.Forward);

    /// <summary>The direction of x.</summary>
    public BodyDirection X { get; }

    /// <summary>The direction of y.</summary>
    public BodyDirection Y { get; }

    /// <summary>The direction of z.</summary>
    public BodyDirection Z { get; }

    /// <summary>Whether the axes are right-handed, like those of BVH.</summary>
    public bool IsRightHanded => _handedness > 0;

    /// <summary>Converts a direction, a velocity or an acceleration to the axes of BVH.</summary>
    /// <param name="vector">The vector in these axes; any unit.</param>
    /// <returns>The vector in the axes of BVH; the same unit.</returns>
    public Vector3 ToBvh(Vector3 vector) => (vector.X * _x) + (vector.Y * _y) + (vector.Z * _z);

    /// <summary>Converts a direction, a velocity or an acceleration from the axes of BVH.</summary>
    /// <param name="vector">The vector in the axes of BVH; any unit.</param>
    /// <returns>The vector in these axes; the same unit.</returns>
    public Vector3 FromBvh(Vector3 vector) => new(Vector3.Dot(vector, _x), Vector3.Dot(vector, _y), Vector3.Dot(vector, _z));

    /// <summary>Converts a rotation to the axes of BVH.</summary>
    /// <param name="rotation">The rotation in these axes.</param>
    /// <returns>The same rotation in the axes of BVH.</returns>
    public Quaternion ToBvh(Quaternion rotation) =>
        new(_handedness * ToBvh(new Vector3(rotation.X, rotation.Y, rotation.Z)), rotation.W);

    /// <summary>Converts a rotation from the axes of BVH.</summary>
    /// <param name="rotation">The rotation in the axes of BVH.</param>
    /// <returns>The same rotation in these axes.</returns>
    public Quaternion FromBvh(Quaternion rotation) =>
        new(_handedness * FromBvh(new Vector3(rotation.X, rotation.Y, rotation.Z)), rotation.W);

    /// <summary>Converts an angular velocity to the axes of BVH. Its sign depends on the handedness of the axes.</summary>
    /// <param name="velocity">The angular velocity in these axes; any unit.</param>
    /// <returns>The angular velocity in the axes of BVH; the same unit.</returns>
    public Vector3 ToBvhAngularVelocity(Vector3 velocity) => _handedness * ToBvh(velocity);

    /// <summary>Converts an angular velocity from the axes of BVH.</summary>
    /// <param name="velocity">The angular velocity in the axes of BVH; any unit.</param>
    /// <returns>The angular velocity in these axes; the same unit.</returns>
    public Vector3 FromBvhAngularVelocity(Vector3 velocity) => _handedness * FromBvh(velocity);

    /// <summary>
    /// Converts the values of a frame from the axes of BVH to these axes. The synthesizer of the server creates values in the axes of BVH. The unit
    /// remains metres.
    /// </summary>
    /// <param name="values">946 or 338 values, which are changed in place.</param>
    /// <exception cref="ArgumentException">The number of values is wrong.</exception>
    public void ConvertFromBvh(Span<float> values) => Convert(values, fromBvh: true);

    /// <summary>Converts the values of a frame from these axes to those of BVH. The unit remains metres.</summary>
    /// <param name="values">946 or 338 values, which are changed in place.</param>
    /// <exception cref="ArgumentException">The number of values is wrong.</exception>
    public void ConvertToBvh(Span<float> values) => Convert(values, fromBvh: false);

    private static Vector3 Direct(BodyDirection direction) => direction switch
    {
        BodyDirection.Left => Vector3.UnitX,
        BodyDirection.Right => -Vector3.UnitX,
        BodyDirection.Up => Vector3.UnitY,
        BodyDirection.Down => -Vector3.UnitY,
        BodyDirection.Forward => Vector3.UnitZ,
        BodyDirection.Backward => -Vector3.UnitZ,
        _ => throw new ArgumentOutOfRangeException(nameof(direction), direction, "The direction must be one of the six values of BodyDirection."),
    };

    private void Convert(Span<float> values, bool fromBvh)
    {
        if (values.Length is not (CalculationFrame.FullValueCount or CalculationFrame.BodyValueCount))
            throw new ArgumentException("A frame must have 946 or 338 values.", nameof(values));

        int boneCount = (values.Length - ContactCount) / ValuesPerBone;
        for (int index = 0; index < boneCount; index++)
        {
            Span<float> bone = values[((index * ValuesPerBone) + (index < CalculationOrder.BodyBoneCount ? 0 : ContactCount))..];
            Convert(bone, 1, fromBvh);
            Convert(bone[3..], 1, fromBvh);
            Convert(bone[7..], _handedness, fromBvh);
            Convert(bone[10..], 1, fromBvh);
            Convert(bone[13..], _handedness, fromBvh);
        }
    }

    private void Convert(Span<float> vector, float sign, bool fromBvh)
    {
        var source = new Vector3(vector[0], vector[1], vector[2]);
        Vector3 target = sign * (fromBvh ? FromBvh(source) : ToBvh(source));
        (vector[0], vector[1], vector[2]) = (target.X, target.Y, target.Z);
    }
}
