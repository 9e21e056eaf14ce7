#nullable enable

using System;
using System.Collections.Generic;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // The rest pose of a figure's transforms, relative to their parents: from its avatar, or else from the bind pose of its skin, or else the current
    // pose.
    internal sealed class RestPose
    {
        public const string FromBindPose = "The avatar does not contain the figure's rest pose. The bind pose is used instead.";

        public const string FromPresent =
            "The figure's rest pose is not known: it has no avatar and no skin. The initial pose is used instead; it must be the T-pose.";

        private readonly Dictionary<string, SkeletonBone> _skeleton = new Dictionary<string, SkeletonBone>(StringComparer.Ordinal);
        private readonly Dictionary<Transform, Matrix4x4> _bound = new Dictionary<Transform, Matrix4x4>();
        private readonly Transform _root;

        private RestPose(Transform root) => _root = root;

        // A note about the rest pose. Empty if there is none.
        public string Note { get; private set; } = string.Empty;

        public static RestPose OfAvatar(Transform root, Avatar avatar)
        {
            var rest = new RestPose(root);
            SkeletonBone[]? skeleton = avatar.humanDescription.skeleton;
            if (skeleton is null || skeleton.Length == 0)
            {
                rest.TakeSkins(FromBindPose);
                return rest;
            }

            // Takes the first transform of a name. Names of an avatar's transforms are unique, but names of attached props need not be.
            foreach (SkeletonBone bone in skeleton)
                rest._skeleton.TryAdd(bone.name, bone);

            return rest;
        }

        public static RestPose OfSkins(Transform root)
        {
            var rest = new RestPose(root);
            rest.TakeSkins(string.Empty);
            return rest;
        }

        // The current pose, whatever the skin says.
        public static RestPose OfPresent(Transform root) => new RestPose(root);

        public void Get(Transform transform, out Vector3 position, out Quaternion rotation, out Vector3 scale)
        {
            if (_skeleton.TryGetValue(transform.name, out SkeletonBone bone))
            {
                (position, rotation, scale) = (bone.position, bone.rotation, bone.scale);
                return;
            }

            if (_bound.Count > 0 && _bound.TryGetValue(transform, out Matrix4x4 world))
            {
                Matrix4x4 local = WorldOf(transform.parent!).inverse * world;
                (position, rotation, scale) = (local.GetColumn(3), local.rotation, local.lossyScale);
                return;
            }

            (position, rotation, scale) = (transform.localPosition, transform.localRotation, transform.localScale);
        }

        // At rest, in the root's space.
        private Matrix4x4 WorldOf(Transform transform)
        {
            if (transform == _root)
                return Matrix4x4.identity;
            if (_bound.TryGetValue(transform, out Matrix4x4 world))
                return world;

            Get(transform, out Vector3 position, out Quaternion rotation, out Vector3 scale);
            return WorldOf(transform.parent!) * Matrix4x4.TRS(position, rotation, scale);
        }

        // A bind pose is the transform of the mesh in a bone's space.
        private void TakeSkins(string note)
        {
            foreach (SkinnedMeshRenderer skin in _root.GetComponentsInChildren<SkinnedMeshRenderer>(true))
            {
                if (skin.sharedMesh == null)
                    continue;

                Matrix4x4[] poses = skin.sharedMesh.bindposes;
                Transform[] bones = skin.bones;
                Matrix4x4 mesh = _root.worldToLocalMatrix * skin.transform.localToWorldMatrix;
                for (int i = 0; i < bones.Length && i < poses.Length; i++)
                {
                    if (bones[i] != null)
                        _bound[bones[i]] = mesh * poses[i].inverse;
                }
            }

            Note = _bound.Count > 0 ? note : FromPresent;
        }
    }
}
