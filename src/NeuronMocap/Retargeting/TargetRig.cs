using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Retargeting;

/// <summary>
/// A character as retargeting sees it: its transforms at rest, and the bones among them. Immutable and thread-safe.
/// </summary>
/// <remarks>
/// All values are in the space of the character's root, whatever its position, rotation and scale. The root of a Humanoid is the transform with the
/// Animator.
/// </remarks>
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
        _scales = new Vector3[nodes.Length];
        _subtreeEnds = new int[nodes.Length];
        _isBelowHips = new bool[nodes.Length];
        IsSheared = MeasureScales();

        _restRotations = new Quaternion[nodes.Length];
        _restPositions = new Vector3[nodes.Length];
        RestMatrices = IsSheared ? new Matrix4x4[nodes.Length] : null;
        _localRest = Array.ConvertAll(_nodes, node => node.Rotation);
        _localRestPositions = Array.ConvertAll(_nodes, node => node.Position);
        ComputeWorld(_localRest, _localRestPositions, _restPositions, _restRotations, RestMatrices, 0, nodes.Length);
        _hipsParentBack = InvertHipsParent(nameof(nodes));

        Facing = facing is { } given ? Quaternion.Normalize(given) : RigFacing.Find(this);
        Up = Vector3.Transform(Vector3.UnitY, Facing);
        LegLength = MeasureLegs();
        HipsHeight = Vector3.Dot(_restPositions[hips], Up);
    }

    /// <summary>Gets the transforms, parents before their children.</summary>
    public ReadOnlySpan<RigNode> Nodes => _nodes;

    /// <summary>Gets whether the bones are Humanoid bones. Otherwise they are bones of the stream.</summary>
    public bool IsHumanoid => _nodeOfBone.Length == 0;

    /// <summary>Gets the node of the hips. Without displacement, it is the only node that moves as well as turns.</summary>
    public int HipsNode { get; }

    /// <summary>Gets the Humanoid bones that have a node, according to <see cref="GetNode(HumanoidBone)"/>.</summary>
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

    /// <summary>Gets the orientation of the resting character in its root: identity if it faces Z with its head up along Y.</summary>
    public Quaternion Facing { get; }

    /// <summary>Gets the direction of the resting character's height, in its root.</summary>
    public Vector3 Up { get; }

    /// <summary>
    /// Gets the length from the joint of the thigh along the leg to the joint of the foot: the mean of both legs, in metres. 0 if no leg is complete.
    /// </summary>
    public float LegLength { get; }

    /// <summary>Gets the height of the resting hips above the root, in metres.</summary>
    public float HipsHeight { get; }

    /// <summary>Gets the rest positions of the nodes, in metres, in the space of the character's root.</summary>
    public ReadOnlySpan<Vector3> RestPositions => _restPositions;

    /// <summary>Gets the rest rotations of the nodes, in the space of the character's root.</summary>
    public ReadOnlySpan<Quaternion> RestRotations => _restRotations;

    /// <summary>Creates a Humanoid character.</summary>
    /// <param name="nodes">Its transforms at rest, parents before their children: at least all bones and all their ancestors.</param>
    /// <param name="nodeByBone">The index of the node for each of the 55 bones, or -1.</param>
    /// <param name="facing">
    /// The orientation of the resting character in its root. Null: determined from the positions of head, arms and legs, to quarter turns.
    /// </param>
    /// <returns>The rig.</returns>
    /// <exception cref="ArgumentException">
    /// A node comes before its parent, has a value that is not a number, or has a rotation of length zero. An index is not that of a node, or two
    /// bones have the same node. The hips are missing, are below another bone, or are below a scale of zero.
    /// </exception>
    public static TargetRig CreateHumanoid(ReadOnlySpan<RigNode> nodes, ReadOnlySpan<int> nodeByBone, Quaternion? facing = null)
    {
        int[] map = CheckMap(nodeByBone, HumanoidBones.Count, nodes.Length);
        return new TargetRig(nodes, map, [], map[(int)HumanoidBone.Hips], facing);
    }

    /// <summary>Creates a generic character, whose transforms follow the bones of the stream one by one.</summary>
    /// <param name="nodes">Its transforms at rest, parents before their children.</param>
    /// <param name="nodeByBone">The index of the node for each of the 59 bones of the stream, or -1.</param>
    /// <param name="facing">As for <see cref="CreateHumanoid"/>.</param>
    /// <returns>The rig.</returns>
    /// <exception cref="ArgumentException">As for <see cref="CreateHumanoid"/>.</exception>
    public static TargetRig CreateGeneric(ReadOnlySpan<RigNode> nodes, ReadOnlySpan<int> nodeByBone, Quaternion? facing = null)
    {
        int[] map = CheckMap(nodeByBone, BoneHierarchy.BoneCount, nodes.Length);
        int[] humanoid = new int[HumanoidBones.Count];
        for (int bone = 0; bone < humanoid.Length; bone++)
        {
            humanoid[bone] = HumanoidMap.GetBone((HumanoidBone)bone, SkeletonVariant.Neck1, HumanoidBoneSet.All) is { } source
                ? map[(int)source]
                : None;
        }

        return new TargetRig(nodes, humanoid, map, map[(int)Bone.Hips], facing);
    }

    /// <summary>Gets the node of a Humanoid bone.</summary>
    /// <param name="bone">The bone.</param>
    /// <returns>Its index, or -1. For a generic rig, the node of the corresponding bone of the stream.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public int GetNode(HumanoidBone bone) => _nodeOf[HumanoidBones.CheckedIndex(bone)];

    /// <summary>Gets the node of a bone of the stream.</summary>
    /// <param name="bone">The bone.</param>
    /// <returns>Its index, or -1. Always -1 for a Humanoid rig.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined.</exception>
    public int GetNode(Bone bone)
    {
        int index = BoneHierarchy.CheckedIndex(bone);
        return IsHumanoid ? None : _nodeOfBone[index];
    }

    /// <summary>Gets the Humanoid bone of a node.</summary>
    /// <param name="node">Index of a node.</param>
    /// <returns>The bone. Null if the node is not a bone, and for generic rigs.</returns>
    public HumanoidBone? GetHumanoidBone(int node) => IsHumanoid && _boneOf[node] != None ? (HumanoidBone)_boneOf[node] : null;

    /// <summary>Gets the bone of the stream that a node follows.</summary>
    /// <param name="node">Index of a node.</param>
    /// <returns>The bone. Null if the node is not a bone, and for Humanoid rigs.</returns>
    public Bone? GetBone(int node) => !IsHumanoid && _boneOf[node] != None ? (Bone)_boneOf[node] : null;

    internal bool IsMapped(int node) => _boneOf[node] != None;

    private static int[] CheckMap(ReadOnlySpan<int> nodeByBone, int boneCount, int nodeCount)
    {
        if (nodeByBone.Length != boneCount)
            throw new ArgumentException($"There must be an index for each of the {boneCount} bones.", nameof(nodeByBone));

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
                throw new ArgumentException($"Node {i}, {node.Name}, comes before its parent.", nameof(nodes));
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
                throw new ArgumentException($"Node {map[bone]}, {_nodes[map[bone]].Name}, is mapped to two bones.", nameof(map));

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
