using System.Numerics;

namespace NeuronMocap.Retargeting;

// A leg of a rig: its place in the newest pose, and the bend that brings the foot to another place.
internal sealed class FootLeg
{
    // The distance from the ankle forward to the ball of the foot, as a fraction of the leg, for rigs without toes.
    private const float UsualToes = 0.16f;

    // As a fraction of the leg's length. Past this point the leg stretches more and more slowly, because a sudden straightening makes the knee jump.
    private const float NearlyStraight = 0.96f;

    private const int MaxAttempts = 8;
    private const float Exact = 1e-4f;

    private readonly TargetRig _rig;
    private readonly int _thigh;
    private readonly int _shin;
    private readonly int _foot;

    // Offsets from the ankle at rest, in the space of the character's root: to the sole under the ankle, and to the ball of the foot, also on the
    // ground.
    private readonly Vector3 _heel;
    private readonly Vector3 _ball;
    private Vector3 _hip;

    private FootLeg(TargetRig rig, int thigh, int shin, int foot)
    {
        (_rig, _thigh, _shin, _foot) = (rig, thigh, shin, foot);
        ReadOnlySpan<Vector3> rest = rig.RestPositions;
        Length = LengthIn(rest);
        Vector3 toes = FindToes() is { } node ? rest[node] : rest[foot] + (Forward * (UsualToes * Length));

        // At rest a figure stands at the height of its root, unless the root is above the feet.
        float ground = Math.Min(0, Math.Min(Height(rest[foot]), Height(toes)));
        _heel = rig.Up * (ground - Height(rest[foot]));
        _ball = toes - rest[foot] + (rig.Up * (ground - Height(toes)));
    }

    // The length of a leg of a sheared rig changes with the pose.
    public float Length { get; private set; }

    public Vector3 Up => _rig.Up;

    public bool IsReady { get; private set; }

    public Vector3 Ankle { get; private set; }

    public Quaternion Rotation { get; private set; }

    // The height of the ankle above the lowest point of the sole, at the current rotation of the foot.
    public float AnkleHeight => -Math.Min(Height(Turned(_heel, Rotation)), Height(Turned(_ball, Rotation)));

    public float SoleHeight => Height(Ankle) - AnkleHeight;

    public float FlatAnkleHeight => -Height(_heel);

    private Vector3 Forward => Vector3.Transform(Vector3.UnitZ, _rig.Facing);

    public static FootLeg? TryCreate(TargetRig rig, HumanoidBone upperLeg, HumanoidBone lowerLeg, HumanoidBone foot)
    {
        (int thigh, int shin, int end) = (rig.GetNode(upperLeg), rig.GetNode(lowerLeg), rig.GetNode(foot));
        bool isLeg = IsDescendantOf(rig, thigh, rig.HipsNode) && IsDescendantOf(rig, shin, thigh) && IsDescendantOf(rig, end, shin);
        return isLeg ? new FootLeg(rig, thigh, shin, end) : null;
    }

    public float Height(Vector3 position) => Vector3.Dot(position, _rig.Up);

    public void Measure(RetargetedPose pose)
    {
        IsReady = pose.IsDriven(_thigh) && pose.IsDriven(_shin) && pose.IsDriven(_foot);
        Length = LengthIn(pose.WorldPositions);
        _hip = pose.WorldPositions[_thigh];
        Ankle = pose.WorldPositions[_foot];
        Rotation = pose.WorldRotations[_foot];
    }

    // How far the hips, raised by the shift, must come down again for the ankle to reach the target.
    public float LoweringFor(Vector3 target, float shift)
    {
        float reach = Math.Max(Stretched(Vector3.Distance(_hip + (_rig.Up * shift), target)), Vector3.Distance(_hip, Ankle));
        return Math.Max(0, Height(_hip) + shift - Height(target) - Drop(_hip, target, reach));
    }

    // The lowest height above or below a place that the stretched leg reaches. The height of the hip joint if the place is too far aside.
    public float LowestReached(RetargetedPose pose, Vector3 place) =>
        Height(pose.WorldPositions[_thigh]) - Drop(pose.WorldPositions[_thigh], place, Length);

    // The rotation that levels the foot and keeps its heading.
    public Quaternion Flattened()
    {
        Quaternion rest = _rig.RestRotations[_foot];
        Vector3 forward = Turned(Forward, Rotation);
        Vector3 level = forward - (_rig.Up * Height(forward));
        return level.LengthSquared() > 1e-4f
            ? AroundUp(Vector3.Normalize(level)) * rest
            : Rotation;
    }

    public void Bend(RetargetedPose pose, Vector3 target, Quaternion rotation)
    {
        // One attempt suffices, except for sheared rigs: the length of their bones changes as they turn.
        Vector3 aim = target;
        for (int attempt = 0; attempt < (_rig.IsSheared ? MaxAttempts : 1); attempt++)
        {
            ReadOnlySpan<Vector3> at = pose.WorldPositions;
            Quaternion upper = pose.WorldRotations[_thigh];
            Quaternion lower = pose.WorldRotations[_shin];
            Vector3 knee = Vector3.Transform(Forward, upper * Quaternion.Conjugate(_rig.RestRotations[_thigh]));
            TwoBoneSolution solution = TwoBoneIk.Solve(at[_thigh], at[_shin], at[_foot], aim, knee);
            pose.SetWorldRotation(_thigh, solution.Upper * upper);
            pose.SetWorldRotation(_shin, solution.Lower * lower);
            Vector3 rest = target - pose.WorldPositions[_foot];
            if (rest.LengthSquared() < Exact * Exact)
                break;

            aim += rest;
        }

        pose.SetWorldRotation(_foot, rotation);
    }

    // The rotation of the actor's foot, with toes raised if they would be below the ground.
    public Quaternion KeepToesAbove(float ground, Vector3 ankle)
    {
        Vector3 ball = Turned(_ball, Rotation);
        float length = ball.Length();
        float least = ground - Height(ankle);
        var axis = Vector3.Cross(ball, _rig.Up);
        if (least <= Height(ball) || least > 0 || axis.LengthSquared() < 1e-6f * length * length)
            return Rotation;

        float angle = MathF.Asin(Math.Max(-1, least / length)) - MathF.Asin(Math.Max(-1, Height(ball) / length));
        return Quaternion.CreateFromAxisAngle(Vector3.Normalize(axis), angle) * Rotation;
    }

    private static bool IsDescendantOf(TargetRig rig, int node, int ancestor)
    {
        if (ancestor < 0)
            return false;
        while (node > ancestor)
            node = rig.Nodes[node].Parent;

        return node == ancestor;
    }

    private float LengthIn(ReadOnlySpan<Vector3> at) => Vector3.Distance(at[_thigh], at[_shin]) + Vector3.Distance(at[_shin], at[_foot]);

    private Vector3 Turned(Vector3 atRest, Quaternion rotation) =>
        Vector3.Transform(atRest, rotation * Quaternion.Conjugate(_rig.RestRotations[_foot]));

    private float Stretched(float distance)
    {
        float from = NearlyStraight * Length;
        float rest = Length - from;
        return distance <= from ? distance : from + (rest * (1 - MathF.Exp((from - distance) / rest)));
    }

    // The vertical distance from the hip joint to the end of a leg of the given length that points to the place.
    private float Drop(Vector3 hip, Vector3 place, float length)
    {
        Vector3 way = place - hip;
        float aside = (way - (_rig.Up * Height(way))).LengthSquared();
        return MathF.Sqrt(Math.Max(0, (length * length) - aside));
    }

    private Quaternion AroundUp(Vector3 direction)
    {
        float angle = MathF.Atan2(Vector3.Dot(_rig.Up, Vector3.Cross(Forward, direction)), Vector3.Dot(Forward, direction));
        return Quaternion.CreateFromAxisAngle(_rig.Up, angle);
    }

    // The child of the foot that is furthest in front of it.
    private int? FindToes()
    {
        int? toes = null;
        float furthest = 0.05f * Length;
        for (int node = _foot + 1; node < _rig.Nodes.Length; node++)
        {
            float ahead = Vector3.Dot(_rig.RestPositions[node] - _rig.RestPositions[_foot], Forward);
            if (_rig.Nodes[node].Parent == _foot && ahead > furthest)
                (toes, furthest) = (node, ahead);
        }

        return toes;
    }
}
