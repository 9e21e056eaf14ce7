#nullable enable
using NeuronMocap.Retargeting;
using NUnit.Framework;
using UnityEngine;
using Numerics = System.Numerics;

namespace NeuronMocap.Unity.Tests
{
    /// <summary>The library's conversion agrees with Unity's own rotations.</summary>
    public sealed class AxesTests
    {
        /// <summary>A turn in the right-handed stream looks the same in Unity's mirrored space.</summary>
        /// <param name="x">Axis of the turn.</param>
        /// <param name="y">As above.</param>
        /// <param name="z">As above.</param>
        [TestCase(1, 0, 0)]
        [TestCase(0, 1, 0)]
        [TestCase(0, 0, 1)]
        [TestCase(0.5f, -0.7f, 0.3f)]
        public void A_turned_point_is_the_mirrored_turned_point(float x, float y, float z)
        {
            var turn = Numerics.Quaternion.CreateFromAxisAngle(Numerics.Vector3.Normalize(new Numerics.Vector3(x, y, z)), 1.1f);
            var point = new Numerics.Vector3(30, 120, -45);

            Numerics.Vector3 expected = UnityAxes.ToUnityPosition(Numerics.Vector3.Transform(point, turn));
            Vector3 actual = ToUnity(UnityAxes.ToUnityRotation(turn)) * ToUnity(UnityAxes.ToUnityPosition(point));

            Assert.That((actual - ToUnity(expected)).magnitude, Is.LessThan(1e-5f));
        }

        private static Vector3 ToUnity(Numerics.Vector3 value) => new Vector3(value.X, value.Y, value.Z);

        private static Quaternion ToUnity(Numerics.Quaternion value) => new Quaternion(value.X, value.Y, value.Z, value.W);
    }
}
