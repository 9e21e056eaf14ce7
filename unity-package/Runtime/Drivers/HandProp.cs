#nullable enable

using NeuronMocap.Retargeting;
using UnityEngine;
using Quaternion = UnityEngine.Quaternion;
using Vector3 = UnityEngine.Vector3;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Moves this object, such as a sword or a ball, with a hand of a figure or another bone. With a Rigidbody, the object moves through physics and
    /// pushes other bodies with the speed of the hand. A Rigidbody that is not kinematic becomes kinematic while it is held, and falls when this
    /// component is disabled. Without a Rigidbody, the object follows after all drivers and spawners.
    /// </summary>
    [AddComponentMenu("NeuronMocap/Hand Prop")]
    [HelpURL(HelpPage.Components + "#hand-prop")]
    [DefaultExecutionOrder(250)]
    public sealed class HandProp : MonoBehaviour
    {
        [Tooltip("The driver of the figure that holds the object.")]
        [SerializeField]
        private FigureDriver? _driver;

        [Tooltip("The bone that the object follows.")]
        [SerializeField]
        private HumanoidBone _bone = HumanoidBone.RightHand;

        [Tooltip("Position relative to the bone, in metres.")]
        [SerializeField]
        private Vector3 _positionOffset;

        [Tooltip("Rotation relative to the bone, in degrees.")]
        [SerializeField]
        private Vector3 _rotationOffset;

        // The place at the end of the last step.
        private Pose? _held;

        // What becomes loose again when it is no longer held.
        private Rigidbody? _loose;

        /// <summary>Gets or sets the driver of the figure that holds the object.</summary>
        public FigureDriver? Driver
        {
            get => _driver;
            set => _driver = value;
        }

        /// <summary>Gets or sets the bone that the object follows. The default is the right hand. A generic rig has bones for most of them.</summary>
        public HumanoidBone Bone
        {
            get => _bone;
            set => _bone = value;
        }

        /// <summary>Gets or sets the place of the object in the axes of the bone, in metres.</summary>
        public Vector3 PositionOffset
        {
            get => _positionOffset;
            set => _positionOffset = value;
        }

        /// <summary>Gets or sets the rotation of the object in the axes of the bone, as Euler angles in degrees.</summary>
        public Vector3 RotationOffset
        {
            get => _rotationOffset;
            set => _rotationOffset = value;
        }

        /// <summary>Sets the offsets so that the object stays at its present place relative to the bone.</summary>
        /// <returns>False if there is no driver, or the figure has no such bone.</returns>
        public bool HoldAsPlaced()
        {
            if (_driver == null || !_driver.TryGetBonePose(_bone, out Vector3 position, out Quaternion rotation))
                return false;

            Quaternion back = Quaternion.Inverse(rotation);
            _positionOffset = back * (transform.position - position);
            _rotationOffset = (back * transform.rotation).eulerAngles;
            return true;
        }

#if UNITY_EDITOR
        [ContextMenu("Hold As Placed")]
        private void HoldAsPlacedFromMenu()
        {
            if (_driver == null || !_driver.TryGetBonePose(_bone, out _, out _))
            {
                Debug.LogWarning(_driver == null ? "Set Driver first." : $"The figure {_driver.name} has no bone {_bone}, or cannot be driven.", this);
                return;
            }

            UnityEditor.Undo.RecordObject(this, "Hold As Placed");
            HoldAsPlaced();
            UnityEditor.PrefabUtility.RecordPrefabInstancePropertyModifications(this);
        }
#endif

        private void OnDisable()
        {
            _held = null;
            if (_loose != null)
                _loose.isKinematic = false;

            _loose = null;
        }

        private void FixedUpdate()
        {
            if (_driver == null)
                OnDisable();
            if (!TryGetComponent(out Rigidbody body) || !TryGetPlace(out Vector3 position, out Quaternion rotation))
                return;

            Hold(body);

            // The object may be below the hand, whose transform takes it along without a velocity.
            if (_held is { } held)
                transform.SetPositionAndRotation(held.position, held.rotation);

            Physics.SyncTransforms();
            KinematicMove.To(body, position, rotation, jumps: _held is null);
            _held = new Pose(position, rotation);
        }

        private void LateUpdate()
        {
            if (!TryGetComponent(out Rigidbody _) && TryGetPlace(out Vector3 position, out Quaternion rotation))
                transform.SetPositionAndRotation(position, rotation);
        }

        // Otherwise, gravity would move the object away from the hand between the steps.
        private void Hold(Rigidbody body)
        {
            if (body.isKinematic)
                return;

            body.isKinematic = true;
            _loose = body;
        }

        private bool TryGetPlace(out Vector3 position, out Quaternion rotation)
        {
            (position, rotation) = (Vector3.zero, Quaternion.identity);
            if (_driver == null || !_driver.TryGetBonePose(_bone, out position, out rotation))
                return false;

            position += rotation * _positionOffset;
            rotation *= Quaternion.Euler(_rotationOffset);
            return true;
        }
    }
}
