using System.Numerics;
using NeuronMocap.Retargeting;

namespace NeuronMocap.Tool.View.Characters;

/// <summary>Converts between glTF's axes and those of <see cref="TargetRig"/>, which are Unity's: the X axis is mirrored. Both use metres.</summary>
internal static class GltfAxes
{
    public static RigNode ToRig(CharacterNode node) =>
        new(node.Name, node.Parent, UnityAxes.Mirror(node.Translation), UnityAxes.ToUnityRotation(node.Rotation), node.Scale);

    public static Vector3 FromRig(Vector3 position) => UnityAxes.Mirror(position);

    public static Quaternion FromRig(Quaternion rotation) => UnityAxes.FromUnityRotation(rotation);
}
