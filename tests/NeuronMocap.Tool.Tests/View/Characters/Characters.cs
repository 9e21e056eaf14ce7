using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Retargeting;
using NeuronMocap.Tool.View.Characters;

namespace NeuronMocap.Tool.Tests.View.Characters;

/// <summary>Characters and poses for tests.</summary>
internal static class Characters
{
    public static readonly Quaternion HalfTurn = Quaternion.CreateFromAxisAngle(Vector3.UnitY, MathF.PI);

    /// <summary>Creates the performer's own skeleton: a node for each bone of the stream.</summary>
    public static CharacterNode[] OfBody(SkeletonBody body) =>
    [
        .. BoneHierarchy.Bones.ToArray().Select(bone => new CharacterNode(
            BoneHierarchy.GetName(bone, body.Variant),
            BoneHierarchy.GetParent(bone, body.Variant) is { } parent ? (int)parent : -1,
            body.GetOffset(bone) / 100)),
    ];

    /// <summary>Loads a skeleton with the names of another program.</summary>
    public static CharacterNode[] OfRig(string name) =>
        [.. RigSkeleton.Load(name).Nodes.Select(static node => new CharacterNode(node.Name, node.Parent, UnityAxes.Mirror(node.Position)))];

    /// <summary>Puts nodes below another node.</summary>
    public static CharacterNode[] Under(CharacterNode top, CharacterNode[] nodes) =>
        [top with { Parent = -1 }, .. nodes.Select(static node => node with { Parent = node.Parent + 1 })];

    /// <summary>Turns nodes in place, in their parents' axes.</summary>
    public static CharacterNode[] Turned(CharacterNode[] nodes, params (string Name, Quaternion Turn)[] turns) =>
    [
        .. nodes.Select(node => turns.FirstOrDefault(turn => turn.Name == node.Name) is { Name: not null } turn
            ? node with { Rotation = turn.Turn * node.Rotation }
            : node),
    ];

    /// <summary>Writes a pose in which every bone is turned and the hips have moved.</summary>
    public static BoneTransform[] Pose(SkeletonBody body, int seed = 1)
    {
        var random = new Random(seed);
        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        body.CopyRestPose(pose);
        for (int bone = 0; bone < pose.Length; bone++)
        {
            var axis = new Vector3(random.NextSingle() - 0.5f, random.NextSingle() - 0.5f, random.NextSingle() - 0.5f);
            float angle = bone == 0 ? 2.5f : 0.6f;
            pose[bone] = pose[bone] with { Rotation = Quaternion.CreateFromAxisAngle(Vector3.Normalize(axis), angle * random.NextSingle()) };
        }

        pose[0] = pose[0] with { Position = pose[0].Position + new Vector3(120, -15, 260) };
        return pose;
    }

    /// <summary>Computes where the performer's joints are, in metres.</summary>
    public static BoneTransform[] WorldOf(BoneTransform[] pose, SkeletonBody body)
    {
        var world = new BoneTransform[pose.Length];
        ForwardKinematics.ToWorld(pose, world, body.Variant);
        return [.. world.Select(static joint => joint with { Position = joint.Position / 100 })];
    }

    /// <summary>Moves a character without planting its feet, and decodes the pose.</summary>
    public static DecodedPose Move(CharacterNode[] nodes, CharacterRig rig, SkeletonBody body, BoneTransform[] pose)
    {
        var poser = new CharacterPoser(rig, body) { PlantsFeet = false };
        Assert.True(poser.TryTake(pose, default, 0));
        byte[] bytes = new byte[CharacterPose.MaxSize];
        int size = CharacterPose.Encode(rig, poser.Pose, 7, 1_234_567, bytes);
        return new DecodedPose(nodes, rig, bytes.AsSpan(0, size));
    }

    public static void AssertNear(Vector3 expected, Vector3 actual, float metres, string where) =>
        Assert.True(Vector3.Distance(expected, actual) <= metres, $"{where}: {expected} and {actual}");
}
