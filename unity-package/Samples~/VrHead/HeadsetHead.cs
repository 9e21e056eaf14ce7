#nullable enable
using NeuronMocap.Retargeting;
using UnityEngine;

namespace NeuronMocap.Unity.Samples
{
    /// <summary>
    /// A figure whose body follows the suit and whose head follows a headset. This component moves the parent of the headset's camera so that the
    /// camera is at the figure's eyes. Only the headset turns the camera, because anything else causes motion sickness. It works with any XR package,
    /// or none: it only needs a transform.
    /// </summary>
    [DefaultExecutionOrder(400)]
    public sealed class HeadsetHead : MonoBehaviour
    {
        // From the end of the neck to the point between the eyes, in front of the face, in metres.
        private static readonly Vector3 Eyes = new Vector3(0, 0.09f, 0.13f);

        [SerializeField]
        [Tooltip("The driver of the figure.")]
        private HumanoidDriver? _driver;

        [SerializeField]
        [Tooltip("The camera's parent: the XR rig or XR origin. This component moves it; only Recenter turns it. It must not be below the figure.")]
        private Transform? _rig;

        [SerializeField]
        [Tooltip("The XR camera, which the headset turns.")]
        private Transform? _headset;

        private Animator? _bound;
        private Transform? _head;
        private Quaternion _headRest;
        private float _suitWeight = 1;

        /// <summary>Gets or sets the driver of the figure.</summary>
        public HumanoidDriver? Driver
        {
            get => _driver;
            set => _driver = value;
        }

        /// <summary>Gets or sets the parent of the camera.</summary>
        public Transform? Rig
        {
            get => _rig;
            set => _rig = value;
        }

        /// <summary>Gets or sets the camera that the headset turns.</summary>
        public Transform? Headset
        {
            get => _headset;
            set => _headset = value;
        }

        /// <summary>Gets the head that the headset turns, or null if there is no figure.</summary>
        public Transform? Head => _head;

        /// <summary>Turns the rig so that the headset looks where the figure's chest points. Call it when the wearer looks straight ahead.</summary>
        [ContextMenu("Recenter")]
        public void Recenter()
        {
            if (_bound == null || _driver == null || _rig == null || _headset == null || !(_driver.Performer is { HasPose: true } performer))
                return;

            Quaternion chest = _bound.transform.rotation * performer.GetRotation(Bone.Spine2);
            float wanted = Heading(chest);
            float now = Heading(_headset.rotation);
            _rig.rotation = Quaternion.Euler(0, wanted - now, 0) * _rig.rotation;
        }

        private static float Heading(Quaternion rotation)
        {
            Vector3 forward = rotation * Vector3.forward;
            return Mathf.Atan2(forward.x, forward.z) * Mathf.Rad2Deg;
        }

        private void OnEnable()
        {
            // The suit moves everything except the head.
            if (_driver == null)
                return;

            _suitWeight = _driver.PartWeights.Get(BodyParts.Head);
            _driver.PartWeights.Set(BodyParts.Head, 0);
        }

        private void OnDisable()
        {
            if (_driver != null)
                _driver.PartWeights.Set(BodyParts.Head, _suitWeight);
        }

        // Runs after the driver and after the headset, whose pose Unity has set by then.
        private void LateUpdate()
        {
            if (_driver == null || _rig == null || _headset == null || !(_driver.ActiveAnimator is { } animator) || !(_driver.TargetRig is { } rig))
                return;

            if (animator != _bound)
                Bind(animator, rig);
            if (_head == null)
                return;

            _head.rotation = _headset.rotation * _headRest;
            _rig.position += _head.position + (_headset.rotation * Eyes) - _headset.position;
        }

        private void Bind(Animator animator, TargetRig rig)
        {
            _bound = animator;
            _head = animator.GetBoneTransform(HumanBodyBones.Head);
            _headRest = rig.RestRotations[rig.GetNode(HumanoidBone.Head)].ToUnity();
        }
    }
}
