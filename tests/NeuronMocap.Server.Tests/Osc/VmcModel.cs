using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Tests.Osc;

/// <summary>
/// A receiver of VMC: a model whose bones have no rotation in the T-pose. It knows the hierarchy of a VRM model, and the bones of the stream by the
/// manual; nothing here is from the library's retargeting.
/// </summary>
internal sealed class VmcModel
{
    private static readonly (string Bone, string Parent, Bone Source)[] Body =
    [
        ("Hips", "root", Bone.Hips),
        ("LeftUpperLeg", "Hips", Bone.LeftUpLeg), ("LeftLowerLeg", "LeftUpperLeg", Bone.LeftLeg), ("LeftFoot", "LeftLowerLeg", Bone.LeftFoot),
        ("RightUpperLeg", "Hips", Bone.RightUpLeg), ("RightLowerLeg", "RightUpperLeg", Bone.RightLeg), ("RightFoot", "RightLowerLeg", Bone.RightFoot),
        ("Spine", "Hips", Bone.Spine), ("Chest", "Spine", Bone.Spine1), ("UpperChest", "Chest", Bone.Spine2),
        ("Neck", "UpperChest", Bone.Neck1), ("Head", "Neck", Bone.Head),
        ("LeftShoulder", "UpperChest", Bone.LeftShoulder), ("LeftUpperArm", "LeftShoulder", Bone.LeftArm),
        ("LeftLowerArm", "LeftUpperArm", Bone.LeftForeArm), ("LeftHand", "LeftLowerArm", Bone.LeftHand),
        ("RightShoulder", "UpperChest", Bone.RightShoulder), ("RightUpperArm", "RightShoulder", Bone.RightArm),
        ("RightLowerArm", "RightUpperArm", Bone.RightForeArm), ("RightHand", "RightLowerArm", Bone.RightHand),
    ];

    private static readonly (string Finger, string Source)[] Fingers = [("Thumb", "Thumb"), ("Index", "Index"), ("Middle", "Middle"), ("Ring", "Ring"), ("Little", "Pinky")];

    private readonly Dictionary<string, BoneTransform> _local = [];

    /// <summary>All bones, parents first.</summary>
    public static IReadOnlyList<(string Bone, string Parent, Bone Source)> Bones { get; } = [.. Body, .. Hands()];

    /// <summary>Number of OK messages with the value 1.</summary>
    public int Frames { get; private set; }

    public float Time { get; private set; }

    public void Receive(OscMessage message)
    {
        switch (message.Address)
        {
            case "/VMC/Ext/Root/Pos":
            case "/VMC/Ext/Bone/Pos":
                Assert.Equal("sfffffff", message.Types);
                _local[(string)message.Arguments[0]] = Poses.TransformOf(message);
                break;
            case "/VMC/Ext/OK":
                Assert.Equal([1], message.Arguments);
                Frames++;
                break;
            case "/VMC/Ext/T":
                Time = message.Float(0);
                break;
            default:
                Assert.Fail(message.Address);
                break;
        }
    }

    /// <summary>The place of each bone in the axes of Unity, in metres.</summary>
    public Dictionary<string, BoneTransform> ToWorld()
    {
        Dictionary<string, BoneTransform> world = new() { ["root"] = _local["root"] };
        foreach ((string bone, string parent, _) in Bones)
            world[bone] = world[parent].Apply(_local[bone]);

        Assert.Equal(Bones.Count + 1, _local.Count);
        return world;
    }

    /// <summary>Asserts that every bone is where a frame has it. X is mirrored, and centimetres become metres.</summary>
    public void AssertShows(MotionFrame frame, float tolerance = 2e-5f, float scale = 1)
    {
        BoneTransform[] expected = Poses.World(frame);
        Dictionary<string, BoneTransform> world = ToWorld();
        foreach ((string bone, _, Bone source) in Bones)
        {
            int index = (int)source;
            if (frame.Format.Variant == SkeletonVariant.Spine3 && bone == "UpperChest")
                index = (int)Bone.Neck;

            (Vector3 place, Quaternion turn) = expected[index];
            var mirrored = new BoneTransform(new Vector3(-place.X, place.Y, place.Z) / 100 * scale, new Quaternion(turn.X, -turn.Y, -turn.Z, turn.W));
            Poses.AssertSame(mirrored, world[bone], tolerance, bone);
        }
    }

    private static IEnumerable<(string Bone, string Parent, Bone Source)> Hands()
    {
        foreach (string side in (string[])["Left", "Right"])
        {
            foreach ((string finger, string source) in Fingers)
            {
                string parent = $"{side}Hand";
                foreach ((string joint, int number) in ((string, int)[])[("Proximal", 1), ("Intermediate", 2), ("Distal", 3)])
                {
                    string bone = $"{side}{finger}{joint}";
                    yield return (bone, parent, Enum.Parse<Bone>($"{side}Hand{source}{number}"));
                    parent = bone;
                }
            }
        }
    }
}
