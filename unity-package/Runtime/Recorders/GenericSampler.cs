#nullable enable
using System.Collections.Generic;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // Samples the local rotations of a character's transforms, and the position of the transform that moves it.
    internal sealed class GenericSampler : ClipSampler
    {
        private readonly Transform _root;
        private readonly Transform _mover;
        private readonly IReadOnlyList<Transform> _bones;

        // Paths start below the root, on which the clip will be played. mover: the hips. bones: all transforms that turn, including the hips.
        public GenericSampler(Transform root, Transform mover, IReadOnlyList<Transform> bones)
            : base(CreateProperties(root, mover, bones))
        {
            _root = root;
            _mover = mover;
            Origin = new TakeOrigin(root);
            _bones = bones;
        }

        public override bool IsGone => _root == null || _mover == null;

        protected override TakeOrigin Origin { get; }

        protected override void Read()
        {
            Origin.Follow();
            bool isRoot = _mover == _root || _mover.parent == null;
            Put(isRoot ? _mover.localPosition : ToStart(_mover.position));
            for (int i = 0; i < _bones.Count; i++)
            {
                // Such as a prop in the hand that was destroyed during the take.
                if (_bones[i] == null)
                    Keep();
                else
                    Put(_bones[i] == _mover && !isRoot ? ToStart(_mover.rotation) : _bones[i].localRotation);
            }
        }

        // The local place of the mover, if the root had stayed.
        private Vector3 ToStart(Vector3 place) =>
            _mover.parent!.InverseTransformPoint(_root.TransformPoint(Origin.ToStart(_root.InverseTransformPoint(place))));

        private Quaternion ToStart(Quaternion rotation) =>
            Quaternion.Inverse(_mover.parent!.rotation) * _root.rotation * Origin.ToStart(Quaternion.Inverse(_root.rotation) * rotation);

        private static IReadOnlyList<ClipProperty> CreateProperties(Transform root, Transform mover, IReadOnlyList<Transform> bones)
        {
            var properties = new List<ClipProperty> { ClipProperty.LocalPosition(GetPath(root, mover)) };
            foreach (Transform bone in bones)
                properties.Add(ClipProperty.LocalRotation(GetPath(root, bone)));

            return properties;
        }

        private static string GetPath(Transform root, Transform node)
        {
            string path = "";
            for (Transform? step = node; step != null && step != root; step = step.parent)
                path = path.Length == 0 ? step.name : step.name + "/" + path;

            return path;
        }
    }
}
