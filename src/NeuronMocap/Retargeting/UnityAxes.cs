using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Retargeting;

/// <summary>
/// Converts between the library's axes and Unity's. The library is right-handed, with Y up, X to the subject's left, Z forward, in centimetres. Unity
/// is left-handed, with Y up, Z forward, in metres.
/// </summary>
/// <remarks>
/// The X axis is mirrored, as in the vendor's scripts. The left hand stays the left hand and is at negative X in Unity. Quaternion arithmetic is the
/// same in both systems, so converted rotations can be multiplied. Allocates nothing; thread-safe.
/// </remarks>
public static class UnityAxes
{
    /// <summary>Converts a position or an offset of the library to Unity.</summary>
    /// <param name="centimetres">Centimetres, right-handed.</param>
    /// <returns>Metres, left-handed.</returns>
    public static Vector3 ToUnityPosition(Vector3 centimetres) => Mirror(centimetres) / 100;

    /// <summary>Converts a position or an offset of Unity to the library.</summary>
    /// <param name="metres">Metres, left-handed.</param>
    /// <returns>Centimetres, right-handed.</returns>
    public static Vector3 FromUnityPosition(Vector3 metres) => Mirror(metres) * 100;

    /// <summary>Converts a direction, or another vector without a unit of length.</summary>
    /// <param name="direction">A direction in the axes of either system.</param>
    /// <returns>The direction in the axes of the other system.</returns>
    public static Vector3 Mirror(Vector3 direction) => new(-direction.X, direction.Y, direction.Z);

    /// <summary>Converts a rotation of the library to Unity.</summary>
    /// <param name="rotation">A rotation for right-handed axes.</param>
    /// <returns>A rotation for left-handed axes, which turns the mirrored object as the argument turns the object.</returns>
    public static Quaternion ToUnityRotation(Quaternion rotation) => Mirror(rotation);

    /// <summary>Converts a rotation of Unity to the library.</summary>
    /// <param name="rotation">A rotation for left-handed axes.</param>
    /// <returns>A rotation for right-handed axes.</returns>
    public static Quaternion FromUnityRotation(Quaternion rotation) => Mirror(rotation);

    /// <summary>Converts three angles of the stream to a quaternion of Unity.</summary>
    /// <param name="degrees">The angles in the order of <paramref name="order"/>: for YXZ, component X is the angle about Y.</param>
    /// <param name="order">The rotation order of the server.</param>
    /// <returns>A rotation for left-handed axes.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The rotation order is not defined.</exception>
    public static Quaternion ToUnityRotation(Vector3 degrees, RotationOrder order) => Mirror(EulerAngles.ToQuaternion(degrees, order));

    /// <summary>
    /// Converts three angles of the stream to Unity's Euler angles.
    /// </summary>
    /// <remarks>
    /// Unity turns about Z, X and Y in this order, which is the stream's YXZ. For YXZ only signs change, and angles of any size are kept. Other
    /// orders go through a quaternion.
    /// </remarks>
    /// <param name="degrees">The angles in the order of <paramref name="order"/>: for YXZ, component X is the angle about Y.</param>
    /// <param name="order">The rotation order of the server.</param>
    /// <returns>Degrees; component X is the angle about X.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The rotation order is not defined.</exception>
    public static Vector3 ToUnityEuler(Vector3 degrees, RotationOrder order) => order == RotationOrder.YXZ
        ? new Vector3(degrees.Y, -degrees.X, -degrees.Z)
        : ToUnityEuler(ToUnityRotation(degrees, order));

    /// <summary>Converts a rotation of Unity to Unity's Euler angles.</summary>
    /// <param name="rotation">A quaternion of Unity of any length except zero.</param>
    /// <returns>Degrees. Component X is the angle about X, within [-90, 90]. The others are within [-180, 180].</returns>
    public static Vector3 ToUnityEuler(Quaternion rotation)
    {
        // The formulas are the same for both hands.
        Vector3 angles = EulerAngles.FromQuaternion(rotation, RotationOrder.YXZ);
        return new Vector3(angles.Y, angles.X, angles.Z);
    }

    /// <summary>Converts Unity's Euler angles to three angles of the stream.</summary>
    /// <param name="degrees">Degrees; component X is the angle about X.</param>
    /// <param name="order">The rotation order of the result.</param>
    /// <returns>
    /// The angles in the order of <paramref name="order"/>. For YXZ the ranges are those of the argument, otherwise those of
    /// <see cref="EulerAngles.FromQuaternion"/>.
    /// </returns>
    /// <exception cref="ArgumentOutOfRangeException">The rotation order is not defined.</exception>
    public static Vector3 FromUnityEuler(Vector3 degrees, RotationOrder order)
    {
        var angles = new Vector3(-degrees.Y, degrees.X, -degrees.Z);
        return order == RotationOrder.YXZ ? angles : EulerAngles.FromQuaternion(EulerAngles.ToQuaternion(angles, RotationOrder.YXZ), order);
    }

    private static Quaternion Mirror(Quaternion rotation) => new(rotation.X, -rotation.Y, -rotation.Z, rotation.W);
}
