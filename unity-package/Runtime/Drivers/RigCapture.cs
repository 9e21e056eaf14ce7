#nullable enable

using System;
using System.Collections.Generic;
using NeuronMocap.Retargeting;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // A figure's transforms at rest, parents first: the bones and their ancestors.
    internal sealed class RigCapture
    {
        private readonly Dictionary<Transform, int> _indices = new Dictionary<Transform, int>();
        private readonly List<Transform> _transforms = new List<Transform>();

        private RigCapture(RigNode[] nodes) => Nodes = nodes;

        public RigNode[] Nodes { get; private set; }

        public Transform[] Transforms => _transforms.ToArray();

        // bones: transforms below the root. Null and transforms of other objects are omitted.
        public static RigCapture Take(Transform root, IReadOnlyList<Transform?> bones, RestPose rest)
        {
            var needed = new HashSet<Transform>();
            for (int i = 0; i < bones.Count; i++)
            {
                Transform? bone = bones[i];
                if (bone == null || bone == root || !bone.IsChildOf(root))
                    continue;

                for (Transform above = bone; above != root; above = above.parent!)
                    needed.Add(above);
            }

            var capture = new RigCapture(Array.Empty<RigNode>());
            var nodes = new List<RigNode>();
            capture.Add(root, -1, needed, rest, nodes);
            capture.Nodes = nodes.ToArray();
            return capture;
        }

        public int IndexOf(Transform? transform) => transform != null && _indices.TryGetValue(transform, out int index) ? index : -1;

        private void Add(Transform parent, int parentIndex, HashSet<Transform> needed, RestPose rest, List<RigNode> nodes)
        {
            for (int i = 0; i < parent.childCount; i++)
            {
                Transform child = parent.GetChild(i);
                if (!needed.Contains(child))
                    continue;

                rest.Get(child, out Vector3 position, out Quaternion rotation, out Vector3 scale);
                int index = nodes.Count;
                _indices.Add(child, index);
                _transforms.Add(child);
                nodes.Add(new RigNode(child.name, parentIndex, position.ToNumerics(), rotation.ToNumerics(), scale.ToNumerics()));
                Add(child, index, needed, rest, nodes);
            }
        }
    }
}
