using System.Numerics;
using NeuronMocap.Retargeting;

namespace NeuronMocap.Tests.Retargeting;

internal enum RigScales
{
    None,

    /// <summary>Negative components.</summary>
    Signs,

    /// <summary>The same along all axes, and an armature in centimetres or inches.</summary>
    Uniform,

    /// <summary>Different between axes, above turned nodes, so that the rig is sheared.</summary>
    Sheared,
}

/// <summary>
/// Characters with any rest pose: proportions, rotations, order of the nodes, existing bones, nodes between and above them. The differences follow
/// from the seed.
/// </summary>
internal sealed class RandomRig
{
    public const int None = -1;

    private readonly Random _random;
    private readonly RigScales _scales;
    private readonly List<RigNode> _nodes = [];
    private readonly List<float> _sizes = [];

    public RandomRig(int seed, RigScales scales, HumanoidBoneSet? bones = null)
    {
        _random = new Random(seed);
        _scales = scales;
        Bones = bones ?? SomeBones();
        NodeOf = [.. Enumerable.Repeat(None, HumanoidBones.Count)];
        Facing = _random.Next(2) == 0 ? Quaternion.Identity : Turn();
        Add(HumanoidBone.Hips, AddArmature());
    }

    public HumanoidBoneSet Bones { get; }

    public RigNode[] Nodes => [.. _nodes];

    public int[] NodeOf { get; }

    public Quaternion Facing { get; }

    public TargetRig Create() => TargetRig.CreateHumanoid(Nodes, NodeOf, Facing);

    // In one of four rigs, even required bones are missing.
    private HumanoidBoneSet SomeBones()
    {
        bool complete = _random.Next(4) != 0;
        HumanoidBoneSet bones = HumanoidBoneSet.All;
        for (HumanoidBone bone = HumanoidBone.LeftUpperLeg; bone <= HumanoidBone.UpperChest; bone++)
        {
            if (_random.Next(3) == 0 && !(complete && HumanoidBones.IsRequired(bone)))
                bones = bones.Without(bone);
        }

        return bones;
    }

    private int AddArmature()
    {
        int parent = None;
        for (int i = _random.Next(3); i > 0; i--)
            parent = AddNode("Armature", parent, isTop: true);

        return parent;
    }

    private void Add(HumanoidBone bone, int parent)
    {
        if (Bones.Contains(bone))
        {
            if (bone != HumanoidBone.Hips && _random.Next(3) == 0)
                parent = AddNode("Twist", parent);
            parent = NodeOf[(int)bone] = AddNode(bone.ToString(), parent);
            if (_random.Next(8) == 0)
                AddNode("Leaf", parent);
        }

        HumanoidBone[] children = [.. Enumerable.Range(0, HumanoidBones.Count).Select(i => (HumanoidBone)i).Where(child => HumanoidBones.GetParent(child) == bone)];
        foreach (HumanoidBone child in children.OrderBy(_ => _random.Next()))
            Add(child, parent);
    }

    private int AddNode(string name, int parent, bool isTop = false)
    {
        Vector3 scale = isTop ? TopScale() : NodeScale();
        float size = parent == None ? 1 : _sizes[parent];
        Vector3 way = Vector3.Transform(new Vector3(0, 0.02f + (_random.NextSingle() * 0.4f), 0), Turn());
        Quaternion rotation = _random.Next(4) == 0 ? Quaternion.Identity : Turn();
        _nodes.Add(new RigNode(name, parent, way / size, rotation, scale));
        _sizes.Add(size * MathF.Cbrt(MathF.Abs(scale.X * scale.Y * scale.Z)));
        return _nodes.Count - 1;
    }

    private Vector3 TopScale() => _scales switch
    {
        RigScales.Uniform => new Vector3(_random.Next(3) switch { 0 => 0.01f, 1 => 100, _ => 0.0254f }),
        RigScales.Signs => new Vector3(-1, 1, 1),
        RigScales.Sheared => new Vector3(1, 1.2f, 0.9f),
        _ => Vector3.One,
    };

    private Vector3 NodeScale()
    {
        if (_random.Next(6) != 0)
            return Vector3.One;

        return _scales switch
        {
            RigScales.Uniform => new Vector3(0.5f + _random.NextSingle()),
            RigScales.Signs => new Vector3(Sign(), Sign(), Sign()),
            RigScales.Sheared => new Vector3(Sign(), 1, Sign()) * new Vector3(0.8f + (_random.NextSingle() * 0.4f), 1.1f, 0.9f),
            _ => Vector3.One,
        };
    }

    private float Sign() => _random.Next(2) == 0 ? -1 : 1;

    private Quaternion Turn() => RandomPoses.Turn(_random);
}
