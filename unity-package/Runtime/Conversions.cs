#nullable enable

using NeuronMocap.Retargeting;
using Numerics = System.Numerics;
using Quaternion = UnityEngine.Quaternion;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Converts between types of <c>System.Numerics</c>, which the library uses, and Unity's types. Thread-safe.
    /// </summary>
    /// <remarks>
    /// <c>ToUnity</c> and <c>ToNumerics</c> change only the type. The other methods also convert between the axes of the stream (right-handed,
    /// centimetres) and Unity's axes (left-handed, metres).
    /// </remarks>
    public static class Conversions
    {
        /// <summary>Converts a vector to Unity's type, with the same values.</summary>
        /// <param name="vector">A vector already in Unity's axes, or independent of axes.</param>
        /// <returns>The same values.</returns>
        public static Vector3 ToUnity(this Numerics.Vector3 vector) => new Vector3(vector.X, vector.Y, vector.Z);

        /// <summary>Converts a rotation to Unity's type, with the same values.</summary>
        /// <param name="rotation">A rotation already in Unity's axes.</param>
        /// <returns>The same values.</returns>
        public static Quaternion ToUnity(this Numerics.Quaternion rotation) => new Quaternion(rotation.X, rotation.Y, rotation.Z, rotation.W);

        /// <summary>Converts a vector to the library's type, with the same values.</summary>
        /// <param name="vector">A vector.</param>
        /// <returns>The same values.</returns>
        public static Numerics.Vector3 ToNumerics(this Vector3 vector) => new Numerics.Vector3(vector.x, vector.y, vector.z);

        /// <summary>Converts a rotation to the library's type, with the same values.</summary>
        /// <param name="rotation">A rotation.</param>
        /// <returns>The same values.</returns>
        public static Numerics.Quaternion ToNumerics(this Quaternion rotation) =>
            new Numerics.Quaternion(rotation.x, rotation.y, rotation.z, rotation.w);

        /// <summary>Converts a position from the stream's axes and centimetres to Unity's axes and metres.</summary>
        /// <param name="centimetres">A position or an offset in the stream's axes.</param>
        /// <returns>The position in metres. Left stays left.</returns>
        public static Vector3 ToUnityPosition(this Numerics.Vector3 centimetres) => UnityAxes.ToUnityPosition(centimetres).ToUnity();

        /// <summary>Converts a rotation from the stream's axes to Unity's.</summary>
        /// <param name="rotation">A rotation in the stream's axes.</param>
        /// <returns>The mirrored rotation.</returns>
        public static Quaternion ToUnityRotation(this Numerics.Quaternion rotation) => UnityAxes.ToUnityRotation(rotation).ToUnity();

        /// <summary>Converts a position from Unity's axes and metres to the stream's axes and centimetres.</summary>
        /// <param name="metres">A position or an offset in Unity's axes.</param>
        /// <returns>The position in centimetres.</returns>
        public static Numerics.Vector3 ToStreamPosition(this Vector3 metres) => UnityAxes.FromUnityPosition(metres.ToNumerics());

        /// <summary>Converts a rotation from Unity's axes to the stream's.</summary>
        /// <param name="rotation">A rotation in Unity's axes.</param>
        /// <returns>The mirrored rotation.</returns>
        public static Numerics.Quaternion ToStreamRotation(this Quaternion rotation) => UnityAxes.FromUnityRotation(rotation.ToNumerics());

        /// <summary>Converts a bone's local transform to a position in metres and a rotation, in Unity's axes.</summary>
        /// <param name="transform">A transform in the stream's axes.</param>
        /// <param name="position">Receives the position in metres.</param>
        /// <param name="rotation">Receives the mirrored rotation.</param>
        public static void ToUnity(this BoneTransform transform, out Vector3 position, out Quaternion rotation)
        {
            position = transform.Position.ToUnityPosition();
            rotation = transform.Rotation.ToUnityRotation();
        }
    }
}
