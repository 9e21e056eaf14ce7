using System.Globalization;
using System.Numerics;

namespace NeuronMocap.Retargeting;

// Checks the rest pose of a rig.
internal static class RigPoseCheck
{
    private const float NoLength = 1e-3f;

    // The greatest height of an ankle above its sole, as a fraction of the leg; and how far a sole may be below the ground.
    private const float HighestAnkle = 0.25f;
    private const float DeepestSole = 0.05f;

    public static IEnumerable<RigIssue> Examine(TargetRig rig)
    {
        foreach (RigIssue issue in ExamineHierarchy(rig).Concat(ExamineAbove(rig)).Concat(ExamineLengths(rig)))
            yield return issue;

        // If the sides are swapped, all angles are wrong, so nothing else is reported.
        RigIssue[] swapped = [.. ExamineSides(rig)];
        foreach (RigIssue issue in swapped.Length > 0 ? swapped : ExaminePose(rig))
            yield return issue;
    }

    private static IEnumerable<RigIssue> ExaminePose(TargetRig rig)
    {
        var walk = new TPoseBuilder(rig);
        walk.Run();
        foreach (TPoseCorrection correction in walk.Corrections)
        {
            string name = HumanoidBones.GetName(correction.Bone);
            string degrees = correction.Degrees.ToString("0", CultureInfo.InvariantCulture);
            yield return new RigIssue(correction.Fault, RigSeverity.Warning, correction.Bone, correction.Degrees, correction.Fault switch
            {
                RigFault.NotUpright => $"At rest the figure is {degrees} degrees from upright. It will move as if it stood upright in that pose.",
                RigFault.NotFacingForward => $"At rest the figure faces {degrees} degrees away from +Z. Unity's Humanoids face +Z.",
                RigFault.PalmNotDown => $"At rest the palm of the {name} faces {degrees} degrees away from the ground. The hand will be twisted by this angle.",
                _ => $"At rest {name} is {degrees} degrees away from a T-pose. It will be off by this angle in every pose.",
            }, CanFix: true);
        }

        if (walk.Corrections.All(static correction => correction.Fault != RigFault.NotUpright) && IsOffTheGround(rig))
        {
            yield return new RigIssue(RigFault.NotOnGround, RigSeverity.Warning, null, 0,
                "At rest the feet are not at the height of the rig's origin, which is its ground. Feet will be planted too high or too low. Move the origin between the feet, or learn the ground height from the motion.",
                CanFix: false);
        }
    }

    private static IEnumerable<RigIssue> ExamineHierarchy(TargetRig rig)
    {
        RigNode[] nodes = rig.Nodes.ToArray();
        for (int node = 0; node < nodes.Length; node++)
        {
            if (!rig.IsMapped(node) || rig.IsBelowHips(node))
                continue;

            string bone = rig.GetHumanoidBone(node)?.ToString() ?? $"{rig.GetBone(node)}";
            yield return new RigIssue(RigFault.InvalidHierarchy, RigSeverity.Warning, rig.GetHumanoidBone(node), 0,
                $"{nodes[node].Name}, which follows {bone}, is not below {nodes[rig.HipsNode].Name}, the hips. It will stay behind as the body moves. Map the hips to the transform that carries the legs and the spine.",
                CanFix: false);
        }
    }

    private static IEnumerable<RigIssue> ExamineAbove(TargetRig rig)
    {
        RigNode[] nodes = rig.Nodes.ToArray();
        for (int node = nodes[rig.HipsNode].Parent; node >= 0; node = nodes[node].Parent)
        {
            float degrees = 2 * MathF.Acos(Math.Min(1, Math.Abs(nodes[node].Rotation.W))) * (180 / MathF.PI);
            if (degrees > 1)
            {
                yield return new RigIssue(RigFault.RootRotated, RigSeverity.Note, null, degrees,
                    $"{nodes[node].Name}, above the hips, is rotated by {degrees.ToString("0", CultureInfo.InvariantCulture)} degrees. Retargeting handles it.",
                    CanFix: false);
            }
        }

        string[] scaled = [.. nodes.Where((node, i) => Vector3.Distance(node.Scale, Vector3.One) > 1e-3f && IsAboveBone(rig, i)).Select(static node => node.Name)];
        if (scaled.Length > 0)
        {
            string which = scaled.Length > 3 ? $"{scaled[0]} and {scaled.Length - 1} others" : string.Join(", ", scaled);
            yield return rig.IsSheared
                ? new RigIssue(RigFault.Scaled, RigSeverity.Warning, null, 0, $"The scale of {which} differs between axes, so the figure is sheared as it turns. Apply the scale in the program that made the rig.", CanFix: false)
                : new RigIssue(RigFault.Scaled, RigSeverity.Note, null, 0, $"The scale of {which} is not 1. Retargeting handles it.", CanFix: false);
        }
    }

    private static bool IsAboveBone(TargetRig rig, int node)
    {
        for (int i = node; i < rig.Nodes.Length; i++)
        {
            int ancestor = i;
            while (rig.IsMapped(i) && ancestor > node)
                ancestor = rig.Nodes[ancestor].Parent;
            if (rig.IsMapped(i) && ancestor == node)
                return true;
        }

        return false;
    }

    private static IEnumerable<RigIssue> ExamineLengths(TargetRig rig)
    {
        foreach (TPoseSegment segment in TPoseSegment.All)
        {
            foreach (HumanoidBone next in segment.Next is { } single ? [single] : segment.Knuckles)
            {
                if (Way(rig, segment.Bone, next) is not { } way || way.Length() >= NoLength * Math.Max(rig.LegLength, 0.1f))
                    continue;

                yield return new RigIssue(RigFault.ZeroLengthBone, RigSeverity.Warning, segment.Bone, 0,
                    $"{HumanoidBones.GetName(segment.Bone)} and {HumanoidBones.GetName(next)} are in the same place. Such a bone has no direction: map the joint where it ends.",
                    CanFix: false);
            }
        }
    }

    // The direction that the left and right sides of hips and shoulders imply must be the direction that the feet point in.
    private static IEnumerable<RigIssue> ExamineSides(TargetRig rig)
    {
        Vector3 up = Way(rig, HumanoidBone.Hips, HumanoidBone.Head) ?? Vector3.UnitY;
        Vector3 hips = Way(rig, HumanoidBone.LeftUpperLeg, HumanoidBone.RightUpperLeg) ?? Vector3.Zero;
        Vector3 shoulders = Way(rig, HumanoidBone.LeftUpperArm, HumanoidBone.RightUpperArm) ?? Vector3.Zero;
        Vector3 feet = (Way(rig, HumanoidBone.LeftFoot, HumanoidBone.LeftToes) ?? Vector3.Zero)
            + (Way(rig, HumanoidBone.RightFoot, HumanoidBone.RightToes) ?? Vector3.Zero);
        float legs = Vector3.Dot(Vector3.Cross(hips, up), feet);
        float arms = Vector3.Dot(Vector3.Cross(shoulders, up), feet);
        if (legs >= 0 && arms >= 0 && Vector3.Dot(hips, shoulders) >= 0)
            yield break;

        string what = (legs < 0, arms < 0) switch
        {
            (true, true) => "The left and the right of the body",
            (true, false) => "The legs",
            (false, true) => "The arms",
            _ => "Either the arms or the legs",
        };
        yield return new RigIssue(RigFault.SidesSwapped, RigSeverity.Error, arms < 0 && legs >= 0 ? HumanoidBone.LeftUpperArm : HumanoidBone.LeftUpperLeg, 0,
            $"{what} are on the wrong sides: bones mapped as left are on the right. Swap left and right in the mapping.", CanFix: false);
    }

    private static bool IsOffTheGround(TargetRig rig)
    {
        float[] heights = [.. new[] { HumanoidBone.LeftFoot, HumanoidBone.RightFoot, HumanoidBone.LeftToes, HumanoidBone.RightToes }
            .Select(rig.GetNode)
            .Where(static node => node >= 0)
            .Select(node => rig.RestPositions[node].Y)];
        return heights.Length > 0 && rig.LegLength > 0
            && (heights.Min() < -DeepestSole * rig.LegLength || heights.Min() > HighestAnkle * rig.LegLength);
    }

    private static Vector3? Way(TargetRig rig, HumanoidBone from, HumanoidBone to)
    {
        (int start, int end) = (rig.GetNode(from), rig.GetNode(to));
        return start < 0 || end < 0 ? null : rig.RestPositions[end] - rig.RestPositions[start];
    }
}
