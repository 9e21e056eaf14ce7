#nullable enable

using NeuronMocap.Retargeting;
using Quaternion = System.Numerics.Quaternion;
using Vector3 = System.Numerics.Vector3;

namespace NeuronMocap.Unity
{
    // Takes the way over the floor and the facing out of a figure's poses. Returns them as steps, in the space of the figure's root.
    internal sealed class RootTravel
    {
        private Vector3 _position;
        private Quaternion _turn;
        private bool _hasPosition;

        // The next pose is the beginning of another way.
        public void Reset() => _hasPosition = false;

        // The step and the turn since the last pose. Both are none for the first pose.
        public (Vector3 Step, Quaternion Turn) Take(RetargetedPose pose)
        {
            TargetRig rig = pose.Rig;
            pose.UpdateWorld();
            Vector3 hips = pose.WorldPositions[rig.HipsNode];
            Quaternion rotation = pose.WorldRotations[rig.HipsNode];
            Vector3 rest = rig.RestPositions[rig.HipsNode];
            Vector3 height = rig.Up * Vector3.Dot(hips - rest, rig.Up);
            Quaternion turn = Heading.About(rig.Up, rotation * Quaternion.Conjugate(rig.RestRotations[rig.HipsNode]));

            // Where the root must be, so that the hips at rest are where they were.
            Vector3 position = hips - height - Vector3.Transform(rest, turn);

            pose.SetHipsWorldPosition(rest + height);
            pose.SetWorldRotation(rig.HipsNode, Quaternion.Conjugate(turn) * rotation);

            // The root already faces as the last pose did.
            Quaternion back = Quaternion.Conjugate(_turn);
            (Vector3, Quaternion) taken = _hasPosition
                ? (Vector3.Transform(position - _position, back), back * turn)
                : (Vector3.Zero, Quaternion.Identity);
            (_position, _turn, _hasPosition) = (position, turn, true);
            return taken;
        }
    }
}
