#nullable enable

using System;
using System.Collections.Generic;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;
using UnityEngine;

namespace NeuronMocap.Unity
{
    /// <summary>
    /// Moves transforms that have no Humanoid avatar: those whose names are the stream's, with a prefix such as "Robot_", and those of an explicit list. They
    /// stand in the T-pose when the component wakes up, unless a skin tells how it was bound.
    /// </summary>
    [AddComponentMenu("NeuronMocap/Generic Rig Driver")]
    public sealed class GenericRigDriver : FigureDriver
    {
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

        [Tooltip("Weights of single bones, on top of those of their parts.")]
        [SerializeField]
        private List<StreamBoneWeight> _boneWeights = new List<StreamBoneWeight>();

        [NonSerialized]
        private Transform? _bound;

        /// <summary>The transform that the rig hangs from; null for this object.</summary>
        public Transform? Root
        {
            get => _root;
            set => _root = value;
        }

        /// <summary>What the names of the transforms begin with; empty to find it out. Call <see cref="FigureDriver.Rebind"/> after a change while it runs.</summary>
        public string Prefix
        {
            get => _prefix;
            set => _prefix = value;
        }

        /// <summary>
        /// Transforms of single bones, before any that are found by name. Call <see cref="FigureDriver.Rebind"/> after a change while it runs.
        /// </summary>
        public IList<BoneBinding> Bindings => _bindings;

        /// <summary>Weights of single bones, on top of those of their parts; bones that are not listed have 1.</summary>
        public IList<StreamBoneWeight> BoneWeights => _boneWeights;

        /// <summary>The bones for which there is no transform, as of the last binding.</summary>
        public IReadOnlyList<Bone> MissingBones { get; private set; } = Array.Empty<Bone>();

        private protected override bool IsBound => _bound != null && _bound == (_root != null ? _root : transform);

        private protected override FigureRig? CreateRig(out string problem)
        {
            Transform root = _root != null ? _root : transform;
            _bound = root;
            Transform?[] bones = FindBones(root);
            if (bones[0] == null)
            {
                problem = $"No transform below {root.name} is called {_prefix}Hips. Change Prefix, or list the transforms in Bindings.";
                return null;
            }

            RestPose rest = RestPose.OfSkins(root);
            RigCapture capture = RigCapture.Take(root, bones, rest);
            try
            {
                problem = string.Empty;
                return new FigureRig(TargetRig.CreateGeneric(capture.Nodes, Array.ConvertAll(bones, capture.IndexOf)), capture.Transforms, rest.Note);
            }
            catch (ArgumentException exception)
            {
                problem = $"The rig cannot be driven: {exception.Message}";
                return null;
            }
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

        internal Transform?[] FindBones(Transform root)
        {
            Transform[] all = root.GetComponentsInChildren<Transform>(true);
            string[] names = Array.ConvertAll(all, node => node.name);

            // The root itself is no bone, whatever it is called.
            names[0] = string.Empty;
            RigBinding binding = RigBinder.Bind(names, _prefix.Length > 0 ? _prefix : null);
            var bones = new Transform?[BoneHierarchy.BoneCount];
            for (int bone = 0; bone < bones.Length; bone++)
                bones[bone] = binding.Nodes[bone] is var node && node > 0 ? all[node] : null;

            foreach (BoneBinding given in _bindings)
            {
                if (given.Transform != null && (uint)given.Bone < BoneHierarchy.BoneCount)
                    Assign(bones, given);
            }

            var missing = new List<Bone>();
            for (int bone = 0; bone < bones.Length; bone++)
            {
                if (bones[bone] == null)
                    missing.Add((Bone)bone);
            }

            MissingBones = missing;
            return bones;
        }

        // A transform is one bone only: the one that it is listed for.
        private static void Assign(Transform?[] bones, BoneBinding given)
        {
            int found = Array.IndexOf(bones, given.Transform);
            if (found >= 0)
                bones[found] = null;

            bones[(int)given.Bone] = given.Transform;
        }
    }
}
