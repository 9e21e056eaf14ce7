#nullable enable

using System.Numerics;

namespace NeuronMocap.Unity
{
    // The facing of a body.
    internal static class Heading
    {
        // The part of a rotation that turns about an axis. The identity if the rotation is half a turn about an axis across.
        public static Quaternion About(Vector3 axis, Quaternion rotation)
        {
            Vector3 along = axis * Vector3.Dot(new Vector3(rotation.X, rotation.Y, rotation.Z), axis);
            var turn = new Quaternion(along, rotation.W);
            return turn.LengthSquared() > 1e-6f ? Quaternion.Normalize(turn) : Quaternion.Identity;
        }
    }
}
