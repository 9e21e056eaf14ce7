using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Retargeting;

/// <summary>
/// A character as retargeting sees it: its transforms at rest, and which of them are bones. The space of everything here is the character's
/// root (of a Humanoid: the transform that has the Animator), whatever place, rotation and scale that has. Immutable; thread-safe.
/// </summary>
public sealed partial class TargetRig
{
    private const int None = -1;

    private readonly RigNode[] _nodes;
    private readonly int[] _nodeOf;
    private readonly int[] _nodeOfBone;
    private readonly int[] _boneOf;
    private readonly Quaternion[] _restRotations;
    private readonly Vector3[] _restPositions;

    private TargetRig(ReadOnlySpan<RigNode> nodes, int[] nodeByBone, int[] nodeOfBone, int hips, Quaternion? facing)
    {
        _nodes = CheckNodes(nodes);
        _nodeOf = nodeByBone;
        _nodeOfBone = nodeOfBone;
        HipsNode = hips;
        _boneOf = InvertMap(IsHumanoid ? nodeByBone : nodeOfBone);
        CheckHips(nameof(nodes));

        _handedness = new Vector3[nodes.Length];
        _offsets = new Vector3[nodes.Length];
        _scales = new Vector3[nodes.Length];
        _subtreeEnds = new int[nodes.Length];
        _isBelowHips = new bool[nodes.Length];
        IsSheared = MeasureScales();

        _restRotations = new Quaternion[nodes.Length];
        _restPositions = new Vector3[nodes.Length];
        RestMatrices = IsSheared ? new Matrix4x4[nodes.Length] : null;
        _localRest = Array.ConvertAll(_nodes, node => node.Rotation);
        ComputeWorld(_localRest, _nodes[hips].Position, _restPositions, _restRotations, RestMatrices, 0, nodes.Length);
        _hipsParentBack = InvertHipsParent(nameof(nodes));

        Facing = facing is { } given ? Quaternion.Normalize(given) : RigFacing.Find(this);
        Up = Vector3.Transform(Vector3.UnitY, Facing);
        LegLength = MeasureLegs();
        HipsHeight = Vector3.Dot(_restPositions[hips], Up);
    }

    /// <summary>The transforms, parents before their children.</summary>
    public ReadOnlySpan<RigNode> Nodes => _nodes;

    /// <summary>Whether the bones are Humanoid bones, else those of the stream.</summary>
    public bool IsHumanoid => _nodeOfBone.Length == 0;

    /// <summary>The node of the hips, the only one that is moved and not only turned.</summary>
    public int HipsNode { get; }

    /// <summary>The Humanoid bones that have a node, by <see cref="GetNode(HumanoidBone)"/>.</summary>
    public HumanoidBoneSet Bones
    {
        get
        {
            HumanoidBoneSet bones = default;
            for (int bone = 0; bone < HumanoidBones.Count; bone++)
            {
                if (_nodeOf[bone] != None)
                    bones = bones.With((HumanoidBone)bone);
            }

            return bones;
        }
    }

    /// <summary>How the resting character is turned in its root: identity when it looks along Z, its head up along Y.</summary>
    public Quaternion Facing { get; }

    /// <summary>The direction of the resting character's height, in its root.</summary>
    public Vector3 Up { get; }

    /// <summary>From the joint of the thigh along the leg to that of the foot, mean of both legs; metres. 0 when no leg is complete.</summary>
    public float LegLength { get; }

    /// <summary>How high the resting hips are above the root; metres.</summary>
    public float HipsHeight { get; }

    /// <summary>Where the nodes are at rest; metres, in the character's root.</summary>
    public ReadOnlySpan<Vector3> RestPositions => _restPositions;

    /// <summary>How the nodes are turned at rest, in the character's root.</summary>
    public ReadOnlySpan<Quaternion> RestRotations => _restRotations;

    /// <summary>A Humanoid character.</summary>
    /// <param name="nodes">Its transforms at rest: at least all bones and everything that they hang from, parents before their children.</param>
    /// <param name="nodeByBone">For each of the 55 bones the index of its node, or -1.</param>
    /// <param name="facing">
    /// How the resting character is turned in its root; null: found from the places of head, arms and legs, to quarter turns.
    /// </param>
    /// <returns>The rig.</returns>
    /// <exception cref="ArgumentException">
    /// A node stands before its parent, has a value that is no number or a rotation of length zero; an index is not that of a node, or two bones have
    /// the same node; the hips are missing, hang from another bone or from a scale of zero.
    /// </exception>
    public static TargetRig CreateHumanoid(ReadOnlySpan<RigNode> nodes, ReadOnlySpan<int> nodeByBone, Quaternion? facing = null)
    {
        int[] map = CheckMap(nodeByBone, HumanoidBones.Count, nodes.Length);
        return new TargetRig(nodes, map, [], map[(int)HumanoidBone.Hips], facing);
    }

    /// <summary>A character whose transforms follow the bones of the stream one by one.</summary>
    /// <param name="nodes">Its transforms at rest, parents before their children.</param>
    /// <param name="nodeByBone">For each of the 59 bones of the stream the index of its node, or -1.</param>
    /// <param name="facing">As for <see cref="CreateHumanoid"/>.</param>
    /// <returns>The rig.</returns>
    /// <exception cref="ArgumentException">As for <see cref="CreateHumanoid"/>.</exception>
    public static TargetRig CreateGeneric(ReadOnlySpan<RigNode> nodes, ReadOnlySpan<int> nodeByBone, Quaternion? facing = null)
    {
        int[] map = CheckMap(nodeByBone, BoneHierarchy.BoneCount, nodes.Length);
        int[] humanoid = new int[HumanoidBones.Count];
        for (int bone = 0; bone < humanoid.Length; bone++)
        {
            humanoid[bone] = HumanoidMap.GetSource((HumanoidBone)bone, SkeletonVariant.Neck1, HumanoidBoneSet.All) is { } source
                ? map[(int)source]
                : None;
        }

        return new TargetRig(nodes, humanoid, map, map[(int)Bone.Hips], facing);
    }

    /// <summary>The node of a Humanoid bone.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>Its index, or -1. Of a generic rig: the node of the stream's bone in the same place.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
    public int GetNode(HumanoidBone bone) => _nodeOf[HumanoidBones.CheckedIndex(bone)];

    /// <summary>The node of a bone of the stream.</summary>
    /// <param name="bone">A bone.</param>
    /// <returns>Its index, or -1; -1 for every bone of a Humanoid rig.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such bone.</exception>
    public int GetNode(Bone bone)
    {
        int index = BoneHierarchy.CheckedIndex(bone);
        return IsHumanoid ? None : _nodeOfBone[index];
    }

    /// <summary>Which Humanoid bone a node is.</summary>
    /// <param name="node">Index of a node.</param>
    /// <returns>Null when it is none, and for generic rigs.</returns>
    public HumanoidBone? GetHumanoidBone(int node) => IsHumanoid && _boneOf[node] != None ? (HumanoidBone)_boneOf[node] : null;

    /// <summary>Which bone of the stream a node follows.</summary>
    /// <param name="node">Index of a node.</param>
    /// <returns>Null when it is none, and for Humanoid rigs.</returns>
    public Bone? GetBone(int node) => !IsHumanoid && _boneOf[node] != None ? (Bone)_boneOf[node] : null;

    internal bool IsMapped(int node) => _boneOf[node] != None;

    private static int[] CheckMap(ReadOnlySpan<int> nodeByBone, int boneCount, int nodeCount)
    {
        if (nodeByBone.Length != boneCount)
            throw new ArgumentException($"There is an index for each of the {boneCount} bones.", nameof(nodeByBone));

        foreach (int node in nodeByBone)
        {
            if (node < None || node >= nodeCount)
                throw new ArgumentException($"Node {node} does not exist.", nameof(nodeByBone));
        }

        return nodeByBone[0] != None ? nodeByBone.ToArray() : throw new ArgumentException("The hips have no node.", nameof(nodeByBone));
    }

    private static RigNode[] CheckNodes(ReadOnlySpan<RigNode> nodes)
    {
        RigNode[] copy = nodes.ToArray();
        for (int i = 0; i < copy.Length; i++)
        {
            RigNode node = copy[i];
            if (node.Parent < None || node.Parent >= i)
                throw new ArgumentException($"Node {i}, {node.Name}, stands before its parent.", nameof(nodes));
            if (!FiniteValues.IsFinite(node.Position) || !FiniteValues.IsFinite(node.Rotation) || !FiniteValues.IsFinite(node.Scale))
                throw new ArgumentException($"Node {i}, {node.Name}, has a value that is not a number.", nameof(nodes));
            if (node.Rotation.LengthSquared() < 1e-6f)
                throw new ArgumentException($"Node {i}, {node.Name}, has a rotation of length zero.", nameof(nodes));

            copy[i] = node with { Rotation = Quaternion.Normalize(node.Rotation) };
        }

        return copy;
    }

    private int[] InvertMap(int[] map)
    {
        int[] boneOf = new int[_nodes.Length];
        Array.Fill(boneOf, None);
        for (int bone = 0; bone < map.Length; bone++)
        {
            if (map[bone] == None)
                continue;
            if (boneOf[map[bone]] != None)
                throw new ArgumentException($"Node {map[bone]}, {_nodes[map[bone]].Name}, is two bones.", nameof(map));

            boneOf[map[bone]] = bone;
        }

        return boneOf;
    }

    private void CheckHips(string nodes)
    {
        for (int node = _nodes[HipsNode].Parent; node != None; node = _nodes[node].Parent)
        {
            if (IsMapped(node))
                throw new ArgumentException($"The hips must not be below another bone, {_nodes[node].Name}.", nodes);
        }
    }

    private float MeasureLegs()
    {
        float left = MeasureLeg(HumanoidBone.LeftUpperLeg, HumanoidBone.LeftLowerLeg, HumanoidBone.LeftFoot);
        float right = MeasureLeg(HumanoidBone.RightUpperLeg, HumanoidBone.RightLowerLeg, HumanoidBone.RightFoot);
        return left == 0 || right == 0 ? left + right : (left + right) / 2;
    }

    private float MeasureLeg(HumanoidBone thigh, HumanoidBone shin, HumanoidBone foot)
    {
        (int upper, int lower, int end) = (GetNode(thigh), GetNode(shin), GetNode(foot));
        return upper == None || lower == None || end == None
            ? 0
            : Vector3.Distance(_restPositions[upper], _restPositions[lower]) + Vector3.Distance(_restPositions[lower], _restPositions[end]);
    }
}
