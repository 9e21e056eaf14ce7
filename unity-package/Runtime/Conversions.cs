#nullable enable

using NeuronMocap.Retargeting;
using Numerics = System.Numerics;
using Quaternion = UnityEngine.Quaternion;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Between the types of <c>System.Numerics</c>, which the library uses, and Unity's. <c>ToUnity</c> and <c>ToNumerics</c> change the type and not a
    /// number; those with a word more also go between the mocap stream's axes (right-handed, centimetres) and Unity's (left-handed, metres). Any thread.
    /// </summary>
    public static class Conversions
    {
        /// <summary>The same numbers as Unity's type.</summary>
        /// <param name="vector">A vector that is in Unity's axes already, or in none.</param>
        /// <returns>The same numbers.</returns>
        public static Vector3 ToUnity(this Numerics.Vector3 vector) => new Vector3(vector.X, vector.Y, vector.Z);

        /// <summary>The same numbers as Unity's type.</summary>
        /// <param name="rotation">A rotation that is in Unity's axes already.</param>
        /// <returns>The same numbers.</returns>
        public static Quaternion ToUnity(this Numerics.Quaternion rotation) => new Quaternion(rotation.X, rotation.Y, rotation.Z, rotation.W);

        /// <summary>The same numbers as the library's type.</summary>
        /// <param name="vector">A vector.</param>
        /// <returns>The same numbers.</returns>
        public static Numerics.Vector3 ToNumerics(this Vector3 vector) => new Numerics.Vector3(vector.x, vector.y, vector.z);

        /// <summary>The same numbers as the library's type.</summary>
        /// <param name="rotation">A rotation.</param>
        /// <returns>The same numbers.</returns>
        public static Numerics.Quaternion ToNumerics(this Quaternion rotation) =>
            new Numerics.Quaternion(rotation.x, rotation.y, rotation.z, rotation.w);

        /// <summary>From the stream's axes and centimetres to Unity's axes and metres.</summary>
        /// <param name="centimetres">A place or an offset as the stream has it.</param>
        /// <returns>Metres; left stays left.</returns>
        public static Vector3 ToUnityPosition(this Numerics.Vector3 centimetres) => UnityAxes.ToUnityPosition(centimetres).ToUnity();

        /// <summary>From the stream's axes to Unity's.</summary>
        /// <param name="rotation">A rotation as the stream has it.</param>
        /// <returns>The mirrored rotation.</returns>
        public static Quaternion ToUnityRotation(this Numerics.Quaternion rotation) => UnityAxes.ToUnityRotation(rotation).ToUnity();

        /// <summary>From Unity's axes and metres to the stream's axes and centimetres.</summary>
        /// <param name="metres">A place or an offset in Unity's axes.</param>
        /// <returns>Centimetres.</returns>
        public static Numerics.Vector3 ToStreamPosition(this Vector3 metres) => UnityAxes.FromUnityPosition(metres.ToNumerics());

        /// <summary>From Unity's axes to the stream's.</summary>
        /// <param name="rotation">A rotation in Unity's axes.</param>
        /// <returns>The mirrored rotation.</returns>
        public static Numerics.Quaternion ToStreamRotation(this Quaternion rotation) => UnityAxes.FromUnityRotation(rotation.ToNumerics());

        /// <summary>Where a bone's local transform puts it, in Unity's axes: position in metres.</summary>
        /// <param name="transform">A transform as the stream has it.</param>
        /// <param name="position">Metres.</param>
        /// <param name="rotation">The mirrored rotation.</param>
        public static void ToUnity(this BoneTransform transform, out Vector3 position, out Quaternion rotation)
        {
            position = transform.Position.ToUnityPosition();
            rotation = transform.Rotation.ToUnityRotation();
        }
    }
}
