#nullable enable

using UnityEngine;

namespace NeuronMocap.Unity
{
    // Moves kinematic bodies in FixedUpdate. Bodies in their way are pushed with the speed of the move.
    internal static class KinematicMove
    {
        // In metres per second. People do not move faster; figures that are placed elsewhere do.
        private const float MaxSpeed = 50;

        public static void To(Rigidbody body, Vector3 position, Quaternion rotation, bool jumps)
        {
            float longest = MaxSpeed * Time.fixedDeltaTime;
            if (jumps || (position - body.position).sqrMagnitude > longest * longest)
            {
                body.position = position;
                body.rotation = rotation;
                return;
            }

            body.MovePosition(position);
            body.MoveRotation(rotation);
        }
    }
}
