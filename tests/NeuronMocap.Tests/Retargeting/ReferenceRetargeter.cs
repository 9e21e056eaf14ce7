using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

/// <summary>
/// Retargets with matrices in double precision, in the world. Each bone's rest rotation is multiplied by the actor's turn and converted back to local
/// rotations through the real hierarchy. It shares no code with the library, which works with quaternions relative to the parent.
/// </summary>
internal sealed class ReferenceRetargeter
{
    private readonly RigNode[] _nodes;
    private readonly Bone?[] _sources;
    private readonly Affine _facing;
    private readonly int _hips;
    private readonly Affine[] _rests;
    private readonly Affine[] _signs;
    private readonly Affine[] _restTurns;
    private readonly Affine _hipsParent;

    public ReferenceRetargeter(RigNode[] nodes, Bone?[] sources, Quaternion facing)
    {
        _nodes = nodes;
        _sources = sources;
        _facing = Affine.Turned(facing);
        _hips = Array.IndexOf(sources, Bone.Hips);
        _rests = [.. nodes.Select(node => Affine.Turned(node.Rotation))];
        _signs = SignsAbove();
        _restTurns = Turns(_rests);
        Affine[] matrices = Matrices(_rests, [nodes[_hips].Position.X, nodes[_hips].Position.Y, nodes[_hips].Position.Z]);
        _hipsParent = nodes[_hips].Parent < 0 ? Affine.Identity : matrices[nodes[_hips].Parent];
        RestPlaces = [.. matrices.Select(matrix => matrix.Place())];
    }

    public double[][] RestPlaces { get; }

    /// <summary>The local rotation of each node, after <see cref="Retarget"/>.</summary>
    public Affine[] LocalTurns { get; private set; } = [];

    public Affine[] WorldTurns { get; private set; } = [];

    public double[][] WorldPlaces { get; private set; } = [];

    public double[] HipsLocalPlace { get; private set; } = [];

    /// <summary>Returns the actor's world turns in Unity's axes.</summary>
    public static Affine[] SourceTurns(BoneTransform[] pose, SkeletonVariant variant, BoneTransform? reference = null)
    {
        Affine[] turns = new Affine[pose.Length];
        for (int bone = 0; bone < turns.Length; bone++)
        {
            Affine above = BoneHierarchy.GetParent((Bone)bone, variant) is { } parent
                ? turns[(int)parent]
                : Affine.Turned(reference?.Rotation ?? Quaternion.Identity);
            turns[bone] = above * Affine.Turned(pose[bone].Rotation);
        }

        return [.. turns.Select(turn => Affine.MirrorX * turn * Affine.MirrorX)];
    }

    /// <summary>Retargets one pose. The weights are those of the nodes.</summary>
    public void Retarget(BoneTransform[] pose, SkeletonBody body, BoneTransform? reference = null, float[]? weights = null)
    {
        Affine?[] source = NodeTurns(SourceTurns(pose, body.Variant, reference), weights);
        LocalTurns = new Affine[_nodes.Length];
        WorldTurns = new Affine[_nodes.Length];
        for (int node = 0; node < _nodes.Length; node++)
        {
            Affine signs = _signs[node];
            Affine above = _nodes[node].Parent < 0 ? Affine.Identity : WorldTurns[_nodes[node].Parent];
            WorldTurns[node] = source[node] is { } turn
                ? _facing * turn * _facing.Back() * _restTurns[node]
                : above * signs * _rests[node] * signs;
            LocalTurns[node] = signs * above.Back() * WorldTurns[node] * signs;
        }

        MoveHips(pose, body, reference, weights?[_hips] ?? 1);
    }

    /// <summary>Returns positions for any local values, such as those of the library.</summary>
    public double[][] PlacesOf(Affine[] localTurns, double[] hipsLocalPlace) => [.. Matrices(localTurns, hipsLocalPlace).Select(matrix => matrix.Place())];

    // Height of the hips above the lowest point of the body, with all rotations zero.
    private static double HeightOf(SkeletonBody body)
    {
        double[] heights = new double[BoneHierarchy.BoneCount];
        double lowest = 0;
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            if (BoneHierarchy.GetParent(bone, body.Variant) is { } parent)
                heights[(int)bone] = heights[(int)parent] + body.Offsets[(int)bone].Y;

            // Bones without an End Site have zero.
            lowest = Math.Min(lowest, heights[(int)bone] + Math.Min(0, body.EndSites[(int)bone].Y));
        }

        return -lowest / 100;
    }

    private static double Length(Vector3 way) => Math.Sqrt(((double)way.X * way.X) + ((double)way.Y * way.Y) + ((double)way.Z * way.Z));

    // The turn of each mapped node: that of the mapped node above it, and a fraction of the joint's turn between them.
    private Affine?[] NodeTurns(Affine[] source, float[]? weights)
    {
        Affine?[] turns = new Affine[_nodes.Length];
        for (int node = 0; node < turns.Length; node++)
        {
            if (_sources[node] is not { } bone)
                continue;

            int above = _nodes[node].Parent;
            while (above >= 0 && turns[above] is null)
                above = _nodes[above].Parent;

            Affine turn = source[(int)bone];
            Affine whole = above < 0 ? Affine.Identity : source[(int)_sources[above]!];
            turns[node] = weights is null ? turn : (above < 0 ? Affine.Identity : turns[above]!) * (whole.Back() * turn).Part(weights[node]);
        }

        return turns;
    }

    private void MoveHips(BoneTransform[] pose, SkeletonBody body, BoneTransform? reference, float weight)
    {
        BoneTransform outer = reference ?? BoneTransform.Identity;
        double[] place = (Affine.Moved(outer.Position) * Affine.Turned(outer.Rotation) * Affine.Moved(pose[0].Position)).Place();
        double scale = Scale(body) * weight;
        double[] way = _facing.Place([-place[0] / 100 * scale, ((place[1] / 100) - HeightOf(body)) * scale, place[2] / 100 * scale]);
        double[] rest = RestPlaces[_hips];
        HipsLocalPlace = _hipsParent.Inverse().Place([rest[0] + way[0], rest[1] + way[1], rest[2] + way[2]]);
        WorldPlaces = PlacesOf(LocalTurns, HipsLocalPlace);
    }

    private double Scale(SkeletonBody body)
    {
        double actor = (Length(body.GetOffset(Bone.LeftLeg)) + Length(body.GetOffset(Bone.LeftFoot))
            + Length(body.GetOffset(Bone.RightLeg)) + Length(body.GetOffset(Bone.RightFoot))) / 200;
        double[] legs = [.. new[] { Leg(Bone.LeftUpLeg), Leg(Bone.RightUpLeg) }.Where(leg => leg > 0)];
        if (legs.Length > 0)
            return legs.Average() / actor;

        // Along the resting character's height.
        double[] up = _facing.Place([0, 1, 0]);
        double height = RestPlaces[_hips].Zip(up, (place, direction) => place * direction).Sum();
        return height > 0 ? height / HeightOf(body) : 1;
    }

    private double Leg(Bone thigh)
    {
        int[] joints = [.. new[] { thigh, thigh + 1, thigh + 2 }.Select(bone => Array.IndexOf(_sources, bone))];
        return Array.IndexOf(joints, -1) >= 0 ? 0 : Distance(joints[0], joints[1]) + Distance(joints[1], joints[2]);
    }

    private double Distance(int from, int to) =>
        Math.Sqrt(RestPlaces[from].Zip(RestPlaces[to], (a, b) => (a - b) * (a - b)).Sum());

    // Unity's convention: below a negative scale, nodes turn the other way about the axes that keep their direction.
    private Affine[] SignsAbove()
    {
        Affine[] signs = new Affine[_nodes.Length];
        for (int node = 0; node < signs.Length; node++)
        {
            int parent = _nodes[node].Parent;
            signs[node] = parent < 0 ? Affine.Identity : signs[parent] * Affine.Signs(_nodes[parent].Scale);
        }

        return signs;
    }

    private Affine[] Turns(Affine[] local)
    {
        Affine[] turns = new Affine[_nodes.Length];
        for (int node = 0; node < turns.Length; node++)
        {
            Affine above = _nodes[node].Parent < 0 ? Affine.Identity : turns[_nodes[node].Parent];
            turns[node] = above * _signs[node] * local[node] * _signs[node];
        }

        return turns;
    }

    private Affine[] Matrices(Affine[] localTurns, double[] hips)
    {
        Affine[] matrices = new Affine[_nodes.Length];
        for (int node = 0; node < matrices.Length; node++)
        {
            Affine moved = node == _hips ? Affine.Moved(hips[0], hips[1], hips[2]) : Affine.Moved(_nodes[node].Position);
            Affine local = moved * localTurns[node] * Affine.Scaled(_nodes[node].Scale);
            matrices[node] = _nodes[node].Parent < 0 ? local : matrices[_nodes[node].Parent] * local;
        }

        return matrices;
    }
}
