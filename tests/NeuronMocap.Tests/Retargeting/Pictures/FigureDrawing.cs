using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting.Pictures;

/// <summary>Draws an actor and a character in Unity's axes, seen from the front and slightly from the side.</summary>
internal sealed class FigureDrawing(SvgDrawing drawing)
{
    public const float PixelsPerMetre = 96;

    private const string Left = "#2471a3";
    private const string Right = "#c0392b";
    private const string Middle = "#566573";

    private static readonly Quaternion View = Quaternion.CreateFromAxisAngle(Vector3.UnitX, -0.12f) * Quaternion.CreateFromAxisAngle(Vector3.UnitY, 0.42f);

    /// <summary>Draws the 59 bones and their ends as thin lines.</summary>
    public void Actor(Vector2 ground, ReadOnlySpan<BoneTransform> world, SkeletonBody body)
    {
        Vector3[] points = new Vector3[JointPositions.Count];
        JointPositions.Copy(world, body, points);
        points = [.. points.Select(UnityAxes.ToUnityPosition)];
        Vector3 center = points[0] * new Vector3(1, 0, 1);
        Ground(ground);
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            string color = ColorOf(BoneHierarchy.GetName(bone));
            if (BoneHierarchy.GetParent(bone, body.Variant) is { } parent)
                drawing.Line(At(ground, points[(int)parent] - center), At(ground, points[(int)bone] - center), color, 2);
            int end = JointPositions.GetEndSiteIndex(bone);
            if (end >= 0)
                drawing.Line(At(ground, points[(int)bone] - center), At(ground, points[end] - center), color, 2);
        }
    }

    /// <summary>Draws bones as thick lines and other nodes as rings. On request, draws each bone's own axes.</summary>
    public void Character(Vector2 ground, RetargetedPose pose, bool withAxes)
    {
        TargetRig rig = pose.Rig;
        Vector3 center = pose.WorldPositions[rig.HipsNode] * new Vector3(1, 0, 1);
        Ground(ground);
        for (int node = 0; node < rig.Nodes.Length; node++)
        {
            if (rig.GetHumanoidBone(node) is { } bone and not (HumanoidBone.LeftEye or HumanoidBone.RightEye or HumanoidBone.Jaw))
                Bone(ground, pose, node, bone, center);
        }

        for (int node = 0; node < rig.Nodes.Length; node++)
        {
            Vector3 place = pose.WorldPositions[node] - center;
            if (rig.GetHumanoidBone(node) is null && rig.Nodes[node].Parent >= 0)
                drawing.Circle(At(ground, place), 2, "#fff", "#222");
            else if (withAxes && rig.GetHumanoidBone(node) is { } bone && !IsSmall(bone))
                Axes(ground, place, pose.WorldRotations[node]);
        }
    }

    private static bool IsSmall(HumanoidBone bone) =>
        HumanoidBones.IsFinger(bone) || bone is HumanoidBone.LeftEye or HumanoidBone.RightEye or HumanoidBone.Jaw;

    private static string ColorOf(string name) =>
        name.StartsWith("Left", StringComparison.Ordinal) ? Left : name.StartsWith("Right", StringComparison.Ordinal) ? Right : Middle;

    // For the viewer, the figure's left, -X, is on the right.
    private static Vector2 At(Vector2 ground, Vector3 place)
    {
        Vector3 seen = Vector3.Transform(place, View) * PixelsPerMetre;
        return ground + new Vector2(-seen.X, -seen.Y);
    }

    private void Ground(Vector2 ground) => drawing.Line(ground - new Vector2(50, 0), ground + new Vector2(50, 0), "#d5d8dc", 3);

    private void Bone(Vector2 ground, RetargetedPose pose, int node, HumanoidBone bone, Vector3 center)
    {
        TargetRig rig = pose.Rig;
        string color = ColorOf(HumanoidBones.GetName(bone));
        int above = rig.Nodes[node].Parent;
        while (above >= 0 && rig.GetHumanoidBone(above) is null)
            above = rig.Nodes[above].Parent;
        Vector2 place = At(ground, pose.WorldPositions[node] - center);
        float thickness = HumanoidBones.IsFinger(bone) ? 2 : 7;
        if (above >= 0)
            drawing.Line(At(ground, pose.WorldPositions[above] - center), place, color, thickness);
        if (bone != HumanoidBone.Head)
            return;

        Quaternion turn = pose.WorldRotations[node] * Quaternion.Conjugate(rig.RestRotations[node]);
        drawing.Circle(At(ground, pose.WorldPositions[node] - center + Vector3.Transform(new Vector3(0, 0.1f, 0), turn)), 10, Middle);
        drawing.Circle(At(ground, pose.WorldPositions[node] - center + Vector3.Transform(new Vector3(0, 0.1f, 0.1f), turn)), 2.5f, "#f5b041");
    }

    private void Axes(Vector2 ground, Vector3 place, Quaternion rotation)
    {
        foreach ((Vector3 axis, string color) in new[] { (Vector3.UnitX, "#e74c3c"), (Vector3.UnitY, "#27ae60"), (Vector3.UnitZ, "#2e86ff") })
            drawing.Line(At(ground, place), At(ground, place + Vector3.Transform(axis * 0.09f, rotation)), color, 1.5f);
    }
}
