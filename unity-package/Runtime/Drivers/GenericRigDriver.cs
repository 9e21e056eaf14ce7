#nullable enable

using System;
using System.Collections.Generic;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Moves transforms without a Humanoid avatar. It finds them by the bone names of the stream or of well-known programs, with a prefix such as
    /// "Robot_", or in an explicit list. The rig's rest pose, which <see cref="RestPoseChoice"/> selects, must be a T-pose.
    /// </summary>
    [AddComponentMenu("NeuronMocap/Generic Rig Driver")]
    [HelpURL(HelpPage.Components + "#generic-rig-driver")]
    public sealed partial class GenericRigDriver : FigureDriver
    {
        private const string NotTPose =
            "At rest, the rig is not in a T-pose, so its limbs are off by the difference. Set Rest Pose Choice to T Pose.";

        [Header("Rig")]
        [Tooltip("The root transform of the rig. Empty: this object.")]
        [SerializeField]
        private Transform? _root;

        [Tooltip("Prefix of the transforms' names, such as Robot_ or mixamorig:. Empty: detected automatically.")]
        [SerializeField]
        private string _prefix = string.Empty;

        [Tooltip("Transforms of single bones. They take precedence over those found by name.")]
        [SerializeField]
        private List<BoneBinding> _bindings = new List<BoneBinding>();

        [Tooltip("The pose that corresponds to the performer's T-pose. T Pose: the bind pose, straightened. Use it for rigs bound in an A-pose.")]
        [SerializeField]
        private RestPoseChoice _restPoseChoice;

        [Tooltip("Weights of single bones, multiplied by those of their body parts.")]
        [SerializeField]
        private List<StreamBoneWeight> _boneWeights = new List<StreamBoneWeight>();

        [NonSerialized]
        private Transform? _bound;

        [NonSerialized]
        private RestPoseChoice _boundChoice;

        /// <summary>Gets or sets the root transform of the rig. Null: this object.</summary>
        public Transform? Root
        {
            get => _root;
            set => _root = value;
        }

        /// <summary>
        /// Gets or sets the prefix of the transforms' names. Empty: detected automatically. Call <see cref="FigureDriver.Rebind"/> after a change at
        /// run time.
        /// </summary>
        public string Prefix
        {
            get => _prefix;
            set => _prefix = value;
        }

        /// <summary>
        /// Gets transforms of single bones. They take precedence over those found by name. Call <see cref="FigureDriver.Rebind"/> after a change at
        /// run time.
        /// </summary>
        public IList<BoneBinding> Bindings => _bindings;

        /// <summary>
        /// Gets or sets which pose of the rig corresponds to the performer's T-pose. The default is the bind pose. A change at run time takes effect
        /// in the next frame.
        /// </summary>
        public RestPoseChoice RestPoseChoice
        {
            get => _restPoseChoice;
            set => _restPoseChoice = value;
        }

        /// <summary>Gets weights of single bones, multiplied by those of their body parts. Bones that are not listed have weight 1.</summary>
        public IList<StreamBoneWeight> BoneWeights => _boneWeights;

        /// <summary>Gets the bones without a transform, as of the last binding.</summary>
        public IReadOnlyList<Bone> MissingBones { get; private set; } = Array.Empty<Bone>();

        internal Transform RigRoot => _root != null ? _root : transform;

        private protected override bool IsBound => !_hasOtherNames && _bound != null && _bound == RigRoot && _boundChoice == _restPoseChoice;

        private protected override FigureRig? CreateRig(out string problem)
        {
            Transform root = RigRoot;
            (_bound, _boundChoice) = (root, _restPoseChoice);
            RememberNames();
            Transform?[] bones = FindBones(root);
            if (bones[0] == null)
            {
                problem = $"No transform below {root.name} is called {_prefix}Hips. Change Prefix, or list the transforms in Bindings.";
                return null;
            }

            try
            {
                problem = string.Empty;
                TargetRig target = CaptureRest(root, bones, out RigCapture capture, out string note);
                return new FigureRig(target, capture.Transforms, note);
            }
            catch (ArgumentException exception)
            {
                problem = $"The rig cannot be driven: {exception.Message}";
                return null;
            }
        }

        // The rig in the chosen rest pose. note: what is wrong with this pose, or empty. Throws an ArgumentException if the rig cannot be driven.
        internal TargetRig CaptureRest(Transform root, Transform?[] bones, out RigCapture capture, out string note)
        {
            RestPose rest = _restPoseChoice == RestPoseChoice.AsItStands ? RestPose.OfPresent(root) : RestPose.OfSkins(root);
            capture = RigCapture.Take(root, bones, rest);
            TargetRig given = TargetRig.CreateGeneric(capture.Nodes, Array.ConvertAll(bones, capture.IndexOf));
            TargetRig straight = TPose.Enforce(given);
            bool isStraight = _restPoseChoice == RestPoseChoice.TPose;
            note = isStraight ? string.Empty : rest.Note.Length > 0 ? rest.Note : straight != given ? NotTPose : string.Empty;
            return isStraight ? straight : given;
        }

        private protected override void CopyBoneWeights(BoneWeights weights)
        {
            for (int i = 0; i < _boneWeights.Count; i++)
            {
                StreamBoneWeight bone = _boneWeights[i];
                if ((uint)bone.Bone < BoneHierarchy.BoneCount)
                    weights[bone.Bone] = Mathf.Clamp01(bone.Weight);
            }
        }
    }
}
