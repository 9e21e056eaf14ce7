using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Retargeting;

// Puts a rig into a T-pose, from the hips outwards, and records each correction. Each bone is measured after the bones above it are corrected.
internal sealed class TPoseBuilder
{
    private const float UsualSlope = 30;

    private readonly TargetRig _rig;
    private readonly RetargetedPose _pose;

    public TPoseBuilder(TargetRig rig)
    {
        ArgumentNullException.ThrowIfNull(rig);
        _rig = rig;
        _pose = new RetargetedPose(rig);
    }

    public List<TPoseCorrection> Corrections { get; } = [];

    public void Run()
    {
        float ankle = LowestAnkle();
        TurnBody();
        Quaternion leftFoot = RotationOf(HumanoidBone.LeftFoot);
        Quaternion rightFoot = RotationOf(HumanoidBone.RightFoot);
        foreach (TPoseSegment segment in TPoseSegment.All)
        {
            if (segment.IsFoot)
                SetFoot(segment, segment.Bone == HumanoidBone.LeftFoot ? leftFoot : rightFoot);
            else
                Straighten(segment);

            if (segment.Bone is HumanoidBone.LeftHand or HumanoidBone.RightHand)
                TurnPalm(segment);
        }

        if (Corrections.Exists(static correction => correction.Fault == RigFault.NotUpright || IsOfLeg(correction.Bone)))
            StandOn(ankle);
    }

    public TargetRig Rebuild()
    {
        RigNode[] nodes = _rig.Nodes.ToArray();
        for (int i = 0; i < nodes.Length; i++)
            nodes[i] = nodes[i] with { Rotation = _pose.LocalRotations[i] };
        nodes[_rig.HipsNode] = nodes[_rig.HipsNode] with { Position = _pose.HipsLocalPosition };

        return _rig.IsHumanoid
            ? TargetRig.CreateHumanoid(nodes, [.. Enumerable.Range(0, HumanoidBones.Count).Select(bone => _rig.GetNode((HumanoidBone)bone))])
            : TargetRig.CreateGeneric(nodes, [.. Enumerable.Range(0, BoneHierarchy.BoneCount).Select(bone => _rig.GetNode((Bone)bone))]);
    }

    private static float Degrees(Vector3 one, Vector3 other) =>
        MathF.Atan2(Vector3.Cross(one, other).Length(), Vector3.Dot(one, other)) * (180 / MathF.PI);

    private Vector3? PositionOf(HumanoidBone bone) => _rig.GetNode(bone) is >= 0 and var node ? _pose.WorldPositions[node] : null;

    private Quaternion RotationOf(HumanoidBone bone) =>
        _rig.GetNode(bone) is >= 0 and var node ? _pose.WorldRotations[node] : Quaternion.Identity;

    private Vector3? Way(HumanoidBone from, HumanoidBone to)
    {
        Vector3 way = (PositionOf(to) - PositionOf(from)) ?? Vector3.Zero;
        return way.Length() > 1e-4f ? Vector3.Normalize(way) : null;
    }

    private static bool IsOfLeg(HumanoidBone bone) => HumanoidBones.GetPart(bone) is BodyParts.LeftLeg or BodyParts.RightLeg;

    private float LowestAnkle() =>
        Math.Min(PositionOf(HumanoidBone.LeftFoot)?.Y ?? float.PositiveInfinity, PositionOf(HumanoidBone.RightFoot)?.Y ?? float.PositiveInfinity);

    // Keeps the ankles at their height if it is a plausible height for standing.
    private void StandOn(float ankle)
    {
        float leg = _rig.LegLength;
        if (!(ankle > 0.05f * leg && ankle < 0.25f * leg))
            ankle = 0.1f * leg;
        float now = LowestAnkle();
        if (FiniteValues.IsFinite(now))
            _pose.SetHipsWorldPosition(_pose.WorldPositions[_rig.HipsNode] + (Vector3.UnitY * (ankle - now)));
    }

    // Stands the body upright first, then turns it to the front.
    private void TurnBody()
    {
        Vector3? up = Way(HumanoidBone.Hips, HumanoidBone.Head);
        Vector3 right = (Way(HumanoidBone.LeftUpperLeg, HumanoidBone.RightUpperLeg) ?? Vector3.Zero)
            + (Way(HumanoidBone.LeftUpperArm, HumanoidBone.RightUpperArm) ?? Vector3.Zero);
        bool lay = up is { } crooked && Degrees(crooked, Vector3.UnitY) > TPoseSegment.Straight * 2;
        Quaternion turn = lay ? TwoBoneIk.ShortestTurn(up!.Value, Vector3.UnitY) : Quaternion.Identity;
        if (lay)
            Corrections.Add(new TPoseCorrection(RigFault.NotUpright, HumanoidBone.Hips, Degrees(up!.Value, Vector3.UnitY)));

        Vector3 side = Vector3.Transform(right, turn) * new Vector3(1, 0, 1);
        Vector3 ahead = Vector3.Cross(side, Vector3.UnitY);
        float heading = MathF.Atan2(ahead.X, ahead.Z);
        float degrees = Math.Abs(heading) * (180 / MathF.PI);
        if (side.Length() > 0.1f && degrees > TPoseSegment.Straight)
        {
            Corrections.Add(new TPoseCorrection(RigFault.NotFacingForward, HumanoidBone.Hips, degrees));
            turn = Quaternion.CreateFromAxisAngle(Vector3.UnitY, -heading) * turn;
        }

        Turn(_rig.HipsNode, turn);
    }

    private void Straighten(TPoseSegment segment)
    {
        if (WayOf(segment) is not { } way)
            return;

        float degrees = Degrees(way, segment.Direction);
        if (!(degrees > segment.Tolerance))
            return;

        Corrections.Add(new TPoseCorrection(RigFault.NotInTPose, segment.Bone, degrees));
        Turn(_rig.GetNode(segment.Bone), TwoBoneIk.ShortestTurn(way, segment.Direction));
    }

    // The direction of a segment. For a hand, the direction to the middle of its knuckles.
    private Vector3? WayOf(TPoseSegment segment)
    {
        if (segment.Next is { } next)
            return Way(segment.Bone, next);

        Vector3 sum = Vector3.Zero;
        foreach (HumanoidBone knuckle in segment.Knuckles)
            sum += Way(segment.Bone, knuckle) ?? Vector3.Zero;
        return sum.Length() > 0.5f ? Vector3.Normalize(sum) : null;
    }

    // A foot that stood keeps its rotation, whatever happened to the leg. A foot that hung from a lifted leg turns with the leg. The slope tells
    // which of the two applies. In both cases the foot points ahead in the end.
    private void SetFoot(TPoseSegment segment, Quaternion rotation)
    {
        int foot = _rig.GetNode(segment.Bone);
        if (foot < 0)
            return;

        Quaternion hanging = _pose.WorldRotations[foot];
        float slope = SlopeFault(segment);
        _pose.SetWorldRotation(foot, rotation);
        if (SlopeFault(segment) > slope + 1)
            _pose.SetWorldRotation(foot, hanging);

        if (WayOf(segment) is not { } way || (way * new Vector3(1, 0, 1)).Length() < 0.2f)
            return;

        float heading = MathF.Atan2(way.X, way.Z);
        float degrees = Math.Abs(heading) * (180 / MathF.PI);
        if (!(degrees > segment.Tolerance))
            return;

        Corrections.Add(new TPoseCorrection(RigFault.NotInTPose, segment.Bone, degrees));
        Turn(foot, Quaternion.CreateFromAxisAngle(Vector3.UnitY, -heading));
    }

    // In degrees, from the slope between ankle and toes of a foot on the ground.
    private float SlopeFault(TPoseSegment foot) =>
        WayOf(foot) is { } way ? Math.Abs((MathF.Asin(Math.Clamp(-way.Y, -1, 1)) * (180 / MathF.PI)) - UsualSlope) : 0;

    // If the palm faces down, the little finger is behind the index finger.
    private void TurnPalm(TPoseSegment hand)
    {
        if (Way(hand.Knuckles[0], hand.Knuckles[^1]) is not { } across)
            return;

        float roll = MathF.Atan2(across.Y, -across.Z);
        float degrees = Math.Abs(roll) * (180 / MathF.PI);
        if (new Vector2(across.Y, across.Z).Length() < 0.3f || !(degrees > TPoseSegment.Palm))
            return;

        Corrections.Add(new TPoseCorrection(RigFault.PalmNotDown, hand.Bone, degrees));
        Turn(_rig.GetNode(hand.Bone), Quaternion.CreateFromAxisAngle(Vector3.UnitX, -roll));
    }

    private void Turn(int node, Quaternion turn)
    {
        if (turn != Quaternion.Identity)
            _pose.SetWorldRotation(node, turn * _pose.WorldRotations[node]);
    }
}

// A correction and its angle.
internal readonly record struct TPoseCorrection(RigFault Fault, HumanoidBone Bone, float Degrees);
