#nullable enable

using System;
using System.Collections.Generic;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // Which transforms the bones are, by name or by the list of bindings.
    public sealed partial class GenericRigDriver
    {
        // As of the last binding.
        [NonSerialized]
        private string _boundPrefix = string.Empty;

        [NonSerialized]
        private readonly List<BoneBinding> _boundBindings = new List<BoneBinding>();

        [NonSerialized]
        private bool _hasOtherNames;

        internal Transform?[] FindBones(Transform root)
        {
            RigBinding binding = BindNames(root, _prefix.Length > 0 ? _prefix : null, out Transform[] all);
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

        // all: the transforms in the order of the binding's nodes.
        internal static RigBinding BindNames(Transform root, string? prefix, out Transform[] all)
        {
            all = root.GetComponentsInChildren<Transform>(true);
            string[] names = Array.ConvertAll(all, node => node.name);

            // The root itself is not a bone, whatever its name.
            names[0] = string.Empty;
            var indices = new Dictionary<Transform, int>();
            var parents = new int[all.Length];
            for (int node = 0; node < all.Length; node++)
            {
                parents[node] = node == 0 ? -1 : indices[all[node].parent!];
                indices.Add(all[node], node);
            }

            return RigBinder.Bind(names, prefix, parents: parents);
        }

        // A transform belongs to one bone only: the bone that it is listed for.
        private static void Assign(Transform?[] bones, BoneBinding given)
        {
            int found = Array.IndexOf(bones, given.Transform);
            if (found >= 0)
                bones[found] = null;

            bones[(int)given.Bone] = given.Transform;
        }

        // After a change in the inspector, and after Undo. Most fields need no new rig.
        private protected override void OnValidate()
        {
            base.OnValidate();
            _hasOtherNames = Rig != null && !(string.Equals(_boundPrefix, _prefix, StringComparison.Ordinal) && HasBoundBindings());
        }

        private void RememberNames()
        {
            (_boundPrefix, _hasOtherNames) = (_prefix, false);
            _boundBindings.Clear();
            _boundBindings.AddRange(_bindings);
        }

        private bool HasBoundBindings()
        {
            if (_boundBindings.Count != _bindings.Count)
                return false;

            for (int i = 0; i < _bindings.Count; i++)
            {
                if (_boundBindings[i].Bone != _bindings[i].Bone || _boundBindings[i].Transform != _bindings[i].Transform)
                    return false;
            }

            return true;
        }
    }
}
