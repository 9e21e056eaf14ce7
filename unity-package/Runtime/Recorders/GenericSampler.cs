#nullable enable
using System.Collections.Generic;
using UnityEngine;

namespace NeuronMocap.Unity
{
    // Samples the local rotations of a character's transforms, and the position of the transform that moves it.
    internal sealed class GenericSampler : ClipSampler
    {
        private readonly Transform _mover;
        private readonly IReadOnlyList<Transform> _bones;

        // Paths start below the root, on which the clip will be played. mover: the hips. bones: all transforms that turn, including the hips.
        public GenericSampler(Transform root, Transform mover, IReadOnlyList<Transform> bones)
            : base(CreateProperties(root, mover, bones))
        {
            _mover = mover;
            _bones = bones;
        }

        protected override void Read()
        {
            Put(_mover.localPosition);
            for (int i = 0; i < _bones.Count; i++)
                Put(_bones[i].localRotation);
        }

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
