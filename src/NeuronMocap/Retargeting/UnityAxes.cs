using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Retargeting;

/// <summary>
/// Converts between the library's axes (right-handed, Y up, X to the subject's left, Z forward; centimetres) and Unity's (left-handed, Y up,
/// Z forward; metres). The X axis is mirrored, as the vendor's scripts do: the left hand stays the left hand and is at negative X in Unity.
/// A quaternion's arithmetic is the same in both, so that results may be multiplied on. Allocates nothing; thread-safe.
/// </summary>
public static class UnityAxes
{
    /// <summary>A place or a way of the library in Unity.</summary>
    /// <param name="centimetres">Centimetres, right-handed.</param>
    /// <returns>Metres, left-handed.</returns>
    public static Vector3 ToUnityPosition(Vector3 centimetres) => Mirror(centimetres) / 100;

    /// <summary>A place or a way of Unity in the library.</summary>
    /// <param name="metres">Metres, left-handed.</param>
    /// <returns>Centimetres, right-handed.</returns>
    public static Vector3 FromUnityPosition(Vector3 metres) => Mirror(metres) * 100;

    /// <summary>A direction, or anything else that has no length to convert.</summary>
    /// <param name="direction">In either's axes.</param>
    /// <returns>In the other's.</returns>
    public static Vector3 Mirror(Vector3 direction) => new(-direction.X, direction.Y, direction.Z);

    /// <summary>A rotation of the library in Unity.</summary>
    /// <param name="rotation">For right-handed axes.</param>
    /// <returns>For left-handed axes: what turns the mirrored object as the argument turns the object.</returns>
    public static Quaternion ToUnityRotation(Quaternion rotation) => Mirror(rotation);

    /// <summary>A rotation of Unity in the library.</summary>
    /// <param name="rotation">For left-handed axes.</param>
    /// <returns>For right-handed axes.</returns>
    public static Quaternion FromUnityRotation(Quaternion rotation) => Mirror(rotation);

    /// <summary>A rotation that the stream gives by three angles, as a quaternion of Unity.</summary>
    /// <param name="degrees">The angles in the order of <paramref name="order"/>: for YXZ, component X is the angle about Y.</param>
    /// <param name="order">What the server is set to.</param>
    /// <returns>For left-handed axes.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such order.</exception>
    public static Quaternion ToUnityRotation(Vector3 degrees, RotationOrder order) => Mirror(EulerAngles.ToQuaternion(degrees, order));

    /// <summary>
    /// A rotation that the stream gives by three angles, as Unity's Euler angles. Unity turns about Z, X and Y in this order, which is the
    /// stream's YXZ: there only the signs change, and angles of any size stay what they are. Other orders go through a quaternion.
    /// </summary>
    /// <param name="degrees">The angles in the order of <paramref name="order"/>: for YXZ, component X is the angle about Y.</param>
    /// <param name="order">What the server is set to.</param>
    /// <returns>Degrees; component X is the angle about X.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such order.</exception>
    public static Vector3 ToUnityEuler(Vector3 degrees, RotationOrder order) => order == RotationOrder.YXZ
        ? new Vector3(degrees.Y, -degrees.X, -degrees.Z)
        : ToUnityEuler(ToUnityRotation(degrees, order));

    /// <summary>A rotation of Unity as Unity's Euler angles.</summary>
    /// <param name="rotation">A quaternion of Unity of any length but zero.</param>
    /// <returns>Degrees; component X, within [-90, 90], is the angle about X, the others are within [-180, 180].</returns>
    public static Vector3 ToUnityEuler(Quaternion rotation)
    {
        // The formulas are the same for both hands.
        Vector3 angles = EulerAngles.FromQuaternion(rotation, RotationOrder.YXZ);
        return new Vector3(angles.Y, angles.X, angles.Z);
    }

    /// <summary>Unity's Euler angles as the three angles of the stream.</summary>
    /// <param name="degrees">Degrees; component X is the angle about X.</param>
    /// <param name="order">What the angles are wanted for.</param>
    /// <returns>The angles in the order of <paramref name="order"/>; ranges as in <see cref="EulerAngles.FromQuaternion"/>, but for YXZ those of the argument.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such order.</exception>
    public static Vector3 FromUnityEuler(Vector3 degrees, RotationOrder order)
    {
        var angles = new Vector3(-degrees.Y, degrees.X, -degrees.Z);
        return order == RotationOrder.YXZ ? angles : EulerAngles.FromQuaternion(EulerAngles.ToQuaternion(angles, RotationOrder.YXZ), order);
    }

    private static Quaternion Mirror(Quaternion rotation) => new(rotation.X, -rotation.Y, -rotation.Z, rotation.W);
}
