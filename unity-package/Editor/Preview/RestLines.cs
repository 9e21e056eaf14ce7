#nullable enable

using System.Collections.Generic;
using NeuronMocap.Retargeting;
using UnityEngine;

namespace NeuronMocap.Unity.EditorTools
{
    // The bones of a generic rig at rest as lines of a preview. Rigs of any size are shown as large as a person.
    internal static class RestLines
    {
        private const float Size = 1.8f; // m

        // A line to each bone from the closest bone above it.
        public static IReadOnlyList<(Vector2 From, Vector2 To, Bone Bone)> Of(TargetRig rig, PreviewView view, Rect rect)
        {
            Bounds bounds = BoundsOf(rig);
            float scale = Size / Mathf.Max(bounds.size.x, bounds.size.y, bounds.size.z, 1e-4f);
            var middle = new Vector3(bounds.center.x, bounds.min.y, bounds.center.z);
            var lines = new List<(Vector2 From, Vector2 To, Bone Bone)>();
            for (int node = 0; node < rig.Nodes.Length; node++)
            {
                int above = rig.Nodes[node].Parent;
                while (above >= 0 && rig.GetBone(above) is null)
                    above = rig.Nodes[above].Parent;

                if (above >= 0 && rig.GetBone(node) is { } bone)
                    lines.Add((Place(above), Place(node), bone));
            }

            return lines;

            Vector2 Place(int node) => view.Project((rig.RestPositions[node].ToUnity() - middle) * scale, rect);
        }

        private static Bounds BoundsOf(TargetRig rig)
        {
            var bounds = new Bounds(rig.RestPositions[rig.HipsNode].ToUnity(), Vector3.zero);
            for (int node = 0; node < rig.Nodes.Length; node++)
            {
                if (rig.GetBone(node) is not null)
                    bounds.Encapsulate(rig.RestPositions[node].ToUnity());
            }

            return bounds;
        }
    }
}
