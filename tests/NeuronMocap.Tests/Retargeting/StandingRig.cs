using System.Numerics;
using NeuronMocap.Retargeting;

namespace NeuronMocap.Tests.Retargeting;

/// <summary>
/// A figure in T-pose, in metres, with its soles at the root. It has every bone and, by default, no rotations. Its parts may be changed until it is
/// built.
/// </summary>
internal sealed class StandingRig
{
    private readonly Dictionary<HumanoidBone, Vector3> _joints = [];
    private readonly Dictionary<HumanoidBone, Quaternion> _axes = [];
    private readonly Dictionary<HumanoidBone, string> _names = [];

    public StandingRig()
        : this(thigh: 0.42f, shin: 0.4f, hips: 0.09f, arm: 0.27f, forearm: 0.25f)
    {
    }

    public StandingRig(float thigh, float shin, float hips, float arm, float forearm)
    {
        float height = Ankle + shin + thigh;
        _joints[HumanoidBone.Hips] = new Vector3(0, height + 0.02f, 0);
        _joints[HumanoidBone.Spine] = new Vector3(0, height + 0.12f, -0.01f);
        _joints[HumanoidBone.Chest] = new Vector3(0, height + 0.26f, -0.02f);
        _joints[HumanoidBone.UpperChest] = new Vector3(0, height + 0.38f, -0.02f);
        _joints[HumanoidBone.Neck] = new Vector3(0, height + 0.53f, 0);
        _joints[HumanoidBone.Head] = new Vector3(0, height + 0.62f, 0.01f);
        _joints[HumanoidBone.Jaw] = new Vector3(0, height + 0.64f, 0.04f);
        for (int right = 0; right < 2; right++)
        {
            void Put(HumanoidBone left, float x, float y, float z) => _joints[left + right] = new Vector3(right == 0 ? -x : x, y, z);
            Put(HumanoidBone.LeftEye, 0.03f, height + 0.69f, 0.09f);
            Put(HumanoidBone.LeftUpperLeg, hips, height, 0);
            Put(HumanoidBone.LeftLowerLeg, hips, height - thigh, 0.005f);
            Put(HumanoidBone.LeftFoot, hips, Ankle, 0);
            Put(HumanoidBone.LeftToes, hips, 0.02f, 0.13f);

            float shoulders = height + 0.48f;
            float elbow = 0.17f + arm;
            float wrist = elbow + forearm;
            Put(HumanoidBone.LeftShoulder, 0.03f, shoulders, 0);
            Put(HumanoidBone.LeftUpperArm, 0.17f, shoulders, 0);
            Put(HumanoidBone.LeftLowerArm, elbow, shoulders, -0.005f);
            Put(HumanoidBone.LeftHand, wrist, shoulders, 0);
            for (int joint = 0; joint < 3; joint++)
            {
                HumanoidBone first = (right == 0 ? HumanoidBone.LeftThumbProximal : HumanoidBone.RightThumbProximal - 1) + joint;
                Put(first, wrist + 0.02f + (joint * 0.02f), shoulders - 0.01f, 0.03f + (joint * 0.02f));
                for (int finger = 1; finger < 5; finger++)
                    Put(first + (finger * 3), wrist + 0.09f + (joint * 0.03f), shoulders, 0.045f - (finger * 0.02f));
            }
        }

        foreach (HumanoidBone bone in _joints.Keys)
            (_axes[bone], _names[bone]) = (Quaternion.Identity, HumanoidBones.GetName(bone));
    }

    public const float Ankle = 0.09f;

    /// <summary>The ancestors of the hips, from the root down.</summary>
    public List<RigNode> Above { get; } = [];

    /// <summary>Whether every bone of arms and legs has a node without a bone in its middle, as the parent of the next bone.</summary>
    public bool HasTwistNodes { get; set; }

    public Quaternion TwistAxes { get; set; } = Quaternion.Identity;

    public static StandingRig Random(Random random)
    {
        var rig = new StandingRig(
            random.Range(0.3f, 0.55f), random.Range(0.3f, 0.55f), random.Range(0.06f, 0.16f), random.Range(0.2f, 0.35f), random.Range(0.2f, 0.35f))
        {
            HasTwistNodes = random.Next(2) == 0,
            TwistAxes = random.Rotation(),
        };
        if (random.Next(2) == 0)
            rig.Above.Add(new RigNode("Armature", -1, random.InBox(0.1f), random.Rotation(), new Vector3(random.Next(2) == 0 ? 0.01f : 39.37f)));
        foreach (HumanoidBone bone in new[] { HumanoidBone.UpperChest, HumanoidBone.Neck, HumanoidBone.LeftShoulder, HumanoidBone.RightToes, HumanoidBone.LeftToes })
        {
            if (random.Next(3) == 0)
                rig.Without(bone);
        }

        return rig.WithAxes(random);
    }

    /// <summary>Turns every bone's own axes at random. The visible figure stays the same.</summary>
    public StandingRig WithAxes(Random random)
    {
        foreach (HumanoidBone bone in _joints.Keys)
            _axes[bone] = random.Rotation();
        return this;
    }

    public StandingRig Without(HumanoidBone bone)
    {
        _joints.Remove(bone);
        return this;
    }

    /// <summary>Turns a bone and its descendants about its joint.</summary>
    public StandingRig Turn(HumanoidBone bone, Vector3 axis, float degrees)
    {
        var turn = Quaternion.CreateFromAxisAngle(Vector3.Normalize(axis), degrees * MathF.PI / 180);
        Vector3 joint = _joints[bone];
        foreach (HumanoidBone hanging in _joints.Keys.Where(other => IsOrHangsFrom(other, bone)).ToArray())
        {
            _joints[hanging] = joint + Vector3.Transform(_joints[hanging] - joint, turn);
            _axes[hanging] = turn * _axes[hanging];
        }

        return this;
    }

    public StandingRig Move(HumanoidBone bone, Vector3 way)
    {
        foreach (HumanoidBone hanging in _joints.Keys.Where(other => IsOrHangsFrom(other, bone)).ToArray())
            _joints[hanging] += way;
        return this;
    }

    public StandingRig Rename(HumanoidBone bone, string name)
    {
        _names[bone] = name;
        return this;
    }

    public Vector3 At(HumanoidBone bone) => _joints[bone];

    public (RigNode[] Nodes, int[] NodeOf) Build()
    {
        List<RigNode> nodes = [.. Above];
        List<Place> worlds = [];
        foreach (RigNode node in nodes)
            worlds.Add((node.Parent < 0 ? Place.Identity : worlds[node.Parent]).Of(node));

        int[] nodeByBone = [.. Enumerable.Repeat(-1, HumanoidBones.Count)];
        foreach (HumanoidBone bone in _joints.Keys.OrderBy(Depth))
        {
            HumanoidBone? parent = ParentOf(bone);
            int above = parent is { } mapped ? nodeByBone[(int)mapped] : Above.Count - 1;
            if (HasTwistNodes && parent is { } upper && HumanoidBones.GetPart(bone) is BodyParts.LeftArm or BodyParts.RightArm or BodyParts.LeftLeg or BodyParts.RightLeg)
                above = Add($"{_names[bone]} Twist", above, (_joints[upper] + _joints[bone]) / 2, TwistAxes * _axes[upper]);
            nodeByBone[(int)bone] = Add(_names[bone], above, _joints[bone], _axes[bone]);
        }

        return ([.. nodes], nodeByBone);

        int Add(string name, int parent, Vector3 position, Quaternion rotation)
        {
            Place outer = parent < 0 ? Place.Identity : worlds[parent];
            var node = new RigNode(name, parent, outer.PointToLocal(position), Quaternion.Normalize(Quaternion.Conjugate(outer.Rotation) * rotation));
            nodes.Add(node);
            worlds.Add(outer.Of(node));
            return nodes.Count - 1;
        }
    }

    public TargetRig Create()
    {
        (RigNode[] nodes, int[] nodeByBone) = Build();
        return TargetRig.CreateHumanoid(nodes, nodeByBone);
    }

    private static bool IsOrHangsFrom(HumanoidBone bone, HumanoidBone ancestor) =>
        bone == ancestor || (HumanoidBones.GetParent(bone) is { } parent && IsOrHangsFrom(parent, ancestor));

    private static int Depth(HumanoidBone bone) => HumanoidBones.GetParent(bone) is { } parent ? 1 + Depth(parent) : 0;

    private HumanoidBone? ParentOf(HumanoidBone bone)
    {
        HumanoidBone? parent = HumanoidBones.GetParent(bone);
        while (parent is { } missing && !_joints.ContainsKey(missing))
            parent = HumanoidBones.GetParent(missing);

        return parent;
    }

    // For uniform scales only.
    private readonly record struct Place(Vector3 Position, Quaternion Rotation, float Scale)
    {
        public static Place Identity => new(Vector3.Zero, Quaternion.Identity, 1);

        public Place Of(RigNode node) =>
            new(Position + Vector3.Transform(node.Position * Scale, Rotation), Rotation * node.Rotation, Scale * node.Scale.X);

        public Vector3 PointToLocal(Vector3 point) => Vector3.Transform(point - Position, Quaternion.Conjugate(Rotation)) / Scale;
    }
}
