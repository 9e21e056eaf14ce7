using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.Tests.Files;

/// <summary>Takes to write, read and draw.</summary>
internal static class Takes
{
    public const string TwoJoints =
        """
        HIERARCHY
        ROOT base
        {
          OFFSET 0 10 0
          CHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation Xrotation
          JOINT lFoot
          {
            OFFSET 1 -10 0
            CHANNELS 1 Xrotation
            End Site
            {
              OFFSET 0 0 2
            }
          }
        }
        MOTION
        Frames: 3
        Frame Time: 0.04
        0 10 0 0 0 0 0
        1 10 0 0 0 0 5
        2 10 0 0 0 0 10

        """;

    /// <summary>The upright default body, moved by a formula.</summary>
    public static BvhDocument Neuron(
        int frames, Action<int, BoneTransform[]> formula, double rate = 60, bool displacement = false, RotationOrder order = RotationOrder.YXZ)
    {
        var layout = new ChannelLayout(displacement, hasReference: false);
        BvhHierarchy hierarchy = BvhBoneHierarchy.Create(new SkeletonFormat(order, SkeletonVariant.Neck1), layout);
        float[] values = new float[frames * layout.ValueCount];
        var source = new Formula(formula);
        for (int frame = 0; frame < frames; frame++)
            source.WriteValues(frame, layout, order, values.AsSpan(frame * layout.ValueCount, layout.ValueCount));

        return new BvhDocument(hierarchy, BvhFrameTime.FromFrameRate(rate), values);
    }

    /// <summary>Some seconds of the simulator's actor, who walks and waves.</summary>
    public static BvhDocument Actor(int frames, double rate = 60, bool displacement = true, RotationOrder order = RotationOrder.YXZ)
    {
        var actor = new SyntheticSource(rate);
        return Neuron(frames, (frame, pose) => actor.GetPose(frame, pose), rate, displacement, order);
    }

    /// <summary>
    /// The text of a take as other programs write it: the character's name before those of the bones, and a joint that is not a bone, such as a prop.
    /// </summary>
    public static string Robot(BvhDocument take)
    {
        using var bytes = new MemoryStream();
        take.Save(bytes);
        string[] parts = System.Text.Encoding.ASCII.GetString(bytes.ToArray()).ReplaceLineEndings("\n").Split("MOTION");
        string hierarchy = parts[0].Replace("ROOT ", "ROOT Robot:", StringComparison.Ordinal).Replace("JOINT ", "JOINT Robot:", StringComparison.Ordinal);
        string[] lines = parts[1].TrimEnd().Split('\n');
        int first = 1 + Array.FindIndex(lines, static line => line.StartsWith("Frame Time", StringComparison.Ordinal));
        IEnumerable<string> rows = lines[first..].Select(static row => row.TrimEnd() + " 0 0 0");
        return $"{hierarchy}ROOT Prop1\n{{\nOFFSET 0 0 0\nCHANNELS 3 Yrotation Xrotation Zrotation\nEnd Site\n{{\nOFFSET 0 1 0\n}}\n}}\n"
            + $"MOTION{string.Join('\n', lines[..first])}\n{string.Join('\n', rows)}\n";
    }

    /// <summary>One metre a second along Z.</summary>
    public static BvhDocument StraightWalk(int frames = 121, double rate = 60) =>
        Neuron(frames, (frame, pose) => Move(pose, new Vector3(0, 0, (float)(frame * 100 / rate))), rate);

    public static void Move(BoneTransform[] pose, Vector3 way) => pose[0] = pose[0] with { Position = pose[0].Position + way };

    private sealed class Formula(Action<int, BoneTransform[]> formula) : MotionSource
    {
        public override double FrameRate => 60;

        public override long? FrameCount => null;

        public override bool HasDisplacement => true;

        public override void GetPose(long frame, Span<BoneTransform> pose)
        {
            BoneTransform[] moved = [.. BoneHierarchy.Bones.ToArray().Select(static bone => new BoneTransform(DefaultOffsets.Get(bone), Quaternion.Identity))];
            formula((int)frame, moved);
            moved.CopyTo(pose);
        }

        public override FootContacts GetFootContacts(long frame) => new(true, true);
    }
}
