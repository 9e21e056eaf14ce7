using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Calculation;

/// <summary>
/// The axes of the world that calculation data are given in, a setting of the server, and the way from them to those of BVH: right-handed, Y up, X to
/// the actor's left, Z forward. Sensors' own axes change their names in the same way, so that a rotation of nothing stays one. Immutable; thread-safe.
/// </summary>
public sealed class CalculationAxes
{
    /// <summary>Centimetres, as BVH has them, in a metre, as calculation data have it.</summary>
    public const float CentimetresPerMetre = 100;

    private const int ValuesPerBone = 16;
    private const int ContactCount = 2;

    private readonly Vector3 _x;
    private readonly Vector3 _y;
    private readonly Vector3 _z;
    private readonly float _handedness;

    /// <summary>Makes axes.</summary>
    /// <param name="x">Where x points.</param>
    /// <param name="y">Where y points.</param>
    /// <param name="z">Where z points.</param>
    /// <exception cref="ArgumentException">Two of them lie on one line.</exception>
    public CalculationAxes(BodyDirection x, BodyDirection y, BodyDirection z)
    {
        (X, Y, Z) = (x, y, z);
        (_x, _y, _z) = (Direct(x), Direct(y), Direct(z));
        _handedness = Vector3.Dot(Vector3.Cross(_x, _y), _z);
        if (_handedness == 0)
            throw new ArgumentException("The three axes must be perpendicular to each other.", nameof(z));
    }

    /// <summary>
    /// Those of exported files: z into the ground, right-handed. x and y lie in the ground, and actors face anywhere: that x is to the left of somebody who
    /// faces as BVH's forward is a choice, which turns a take about the vertical at most. The evidence is in docs/guide/calculation.md.
    /// </summary>
    public static CalculationAxes Export { get; } = new(BodyDirection.Left, BodyDirection.Forward, BodyDirection.Down);

    /// <summary>Those of BVH.</summary>
    public static CalculationAxes Bvh { get; } = new(BodyDirection.Left, BodyDirection.Up, BodyDirection.Forward);

    /// <summary>Where x points.</summary>
    public BodyDirection X { get; }

    /// <summary>Where y points.</summary>
    public BodyDirection Y { get; }

    /// <summary>Where z points.</summary>
    public BodyDirection Z { get; }

    /// <summary>Whether the axes are right-handed, as those of BVH.</summary>
    public bool IsRightHanded => _handedness > 0;

    /// <summary>Turns a direction, a velocity or an acceleration into the axes of BVH.</summary>
    /// <param name="vector">In these axes; any unit.</param>
    /// <returns>In BVH's axes; the same unit.</returns>
    public Vector3 ToBvh(Vector3 vector) => (vector.X * _x) + (vector.Y * _y) + (vector.Z * _z);

    /// <summary>Turns a direction, a velocity or an acceleration from the axes of BVH.</summary>
    /// <param name="vector">In BVH's axes; any unit.</param>
    /// <returns>In these axes; the same unit.</returns>
    public Vector3 FromBvh(Vector3 vector) => new(Vector3.Dot(vector, _x), Vector3.Dot(vector, _y), Vector3.Dot(vector, _z));

    /// <summary>Turns a rotation into the axes of BVH.</summary>
    /// <param name="rotation">In these axes.</param>
    /// <returns>The same rotation in BVH's axes.</returns>
    public Quaternion ToBvh(Quaternion rotation) =>
        new(_handedness * ToBvh(new Vector3(rotation.X, rotation.Y, rotation.Z)), rotation.W);

    /// <summary>Turns a rotation from the axes of BVH.</summary>
    /// <param name="rotation">In BVH's axes.</param>
    /// <returns>The same rotation in these axes.</returns>
    public Quaternion FromBvh(Quaternion rotation) =>
        new(_handedness * FromBvh(new Vector3(rotation.X, rotation.Y, rotation.Z)), rotation.W);

    /// <summary>Turns an angular velocity, which follows the handedness of its axes, into those of BVH.</summary>
    /// <param name="velocity">In these axes; any unit.</param>
    /// <returns>In BVH's axes; the same unit.</returns>
    public Vector3 ToBvhAngularVelocity(Vector3 velocity) => _handedness * ToBvh(velocity);

    /// <summary>Turns an angular velocity from the axes of BVH.</summary>
    /// <param name="velocity">In BVH's axes; any unit.</param>
    /// <returns>In these axes; the same unit.</returns>
    public Vector3 FromBvhAngularVelocity(Vector3 velocity) => _handedness * FromBvh(velocity);

    /// <summary>
    /// Turns the values of a frame from the axes of BVH, as the server's synthesizer makes them, into these. Units stay the same: metres.
    /// </summary>
    /// <param name="values">946 values or 338; changed in place.</param>
    /// <exception cref="ArgumentException">There is another number of them.</exception>
    public void ConvertFromBvh(Span<float> values) => Convert(values, fromBvh: true);

    /// <summary>Turns the values of a frame from these axes into those of BVH. Units stay the same: metres.</summary>
    /// <param name="values">946 values or 338; changed in place.</param>
    /// <exception cref="ArgumentException">There is another number of them.</exception>
    public void ConvertToBvh(Span<float> values) => Convert(values, fromBvh: false);

    private static Vector3 Direct(BodyDirection direction) => direction switch
    {
        BodyDirection.Left => Vector3.UnitX,
        BodyDirection.Right => -Vector3.UnitX,
        BodyDirection.Up => Vector3.UnitY,
        BodyDirection.Down => -Vector3.UnitY,
        BodyDirection.Forward => Vector3.UnitZ,
        BodyDirection.Backward => -Vector3.UnitZ,
        _ => throw new ArgumentOutOfRangeException(nameof(direction), direction, "The direction is not one of the six."),
    };

    private void Convert(Span<float> values, bool fromBvh)
    {
        if (values.Length is not (CalculationFrame.FullValueCount or CalculationFrame.BodyValueCount))
            throw new ArgumentException("A frame has 946 values or 338.", nameof(values));

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
