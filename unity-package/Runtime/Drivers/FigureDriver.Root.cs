#nullable enable

using System;
using UnityEngine;
using Quaternion = UnityEngine.Quaternion;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    // Root motion that moves the figure's root or its character controller.
    public abstract partial class FigureDriver
    {
        private const string NoController =
            "No Character Controller found. Add one to the object that carries the figure, or set Root Motion Target to Root Transform.";

        [NonSerialized]
        private readonly RootTravel _travel = new RootTravel();

        [NonSerialized]
        private CharacterController? _controller;

        [NonSerialized]
        private float _fallSpeed;

        [NonSerialized]
        private Vector3 _remainder;

        // The capsules of a figure would stop or lift its own controller. Unity forgets this when a collider is deactivated.
        internal void IgnoreOwnColliders()
        {
            if (_controller == null)
                return;

            foreach (Collider part in _controller.GetComponentsInChildren<Collider>())
            {
                if (part != _controller)
                    Physics.IgnoreCollision(_controller, part);
            }
        }

        private void MoveRoot(FigureRig rig)
        {
            if (_rootMotionTarget == RootMotionTarget.Hips || rig.Root == null || !rig.Pose.IsDriven(rig.Target.HipsNode))
            {
                _travel.Reset();
                return;
            }

            (System.Numerics.Vector3 step, System.Numerics.Quaternion turn) = _travel.Take(rig.Pose);
            float weight = Mathf.Clamp01(_weight) * _presence;
            Transform space = rig.Root;
            Vector3 motion = space.TransformVector(step.ToUnity()) * weight;
            Quaternion rotation = space.rotation * Quaternion.Slerp(Quaternion.identity, turn.ToUnity(), weight) * Quaternion.Inverse(space.rotation);

            if (_isStep)
                rig.Bodies.Hold(rig.Pose);

            // The figure may be below the object with this component, or elsewhere. What moves turns about the root of the rig.
            Transform root = space.IsChildOf(transform) ? transform : space;
            if (_rootMotionTarget == RootMotionTarget.RootTransform)
            {
                SaveCarrier(root);
                Vector3 place = space.position + motion + (rotation * (root.position - space.position));
                root.SetPositionAndRotation(place, rotation * root.rotation);
                return;
            }

            if (_controller == null)
            {
                _controller = root.GetComponentInParent<CharacterController>();
                IgnoreOwnColliders();
            }

            if (_controller == null)
                return;

            Transform carrier = _controller.transform;
            SaveCarrier(carrier);
            Vector3 arm = carrier.position - space.position;
            carrier.rotation = rotation * carrier.rotation;
            MoveController(_controller, motion + (rotation * arm) - arm);
        }

        // The next movement may belong to another controller, and begins without a fall.
        private void ForgetController()
        {
            _controller = null;
            (_fallSpeed, _remainder) = (0, Vector3.zero);
        }

        // Gravity keeps the controller on the ground, so that it notices the ground and follows slopes and steps.
        private void MoveController(CharacterController controller, Vector3 motion)
        {
            if (!controller.enabled || !controller.gameObject.activeInHierarchy)
                return;

            // Without play mode, there is no physics.
            if (!Application.isPlaying)
            {
                controller.transform.position += motion;
                return;
            }

            if (controller.isGrounded && _fallSpeed < 0)
                _fallSpeed = 0;

            // A controller ignores short ways, such as those of a high frame rate.
            _fallSpeed += Physics.gravity.y * Time.deltaTime;
            Vector3 way = _remainder + motion + (Vector3.up * (_fallSpeed * Time.deltaTime));
            bool isShort = way.magnitude < controller.minMoveDistance;
            _remainder = isShort ? way : Vector3.zero;
            if (!isShort)
                controller.Move(way);
        }
    }
}
