using System.Numerics;
using System.Text.Json;
using NeuronMocap.Bvh;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.Info;

public sealed class BvhInfoTests : InfoPages
{
    [Fact]
    public async Task Json_has_the_names_of_all_joints()
    {
        string[] names = [.. Enumerable.Range(0, 40).Select(static number => $"joint{number}")];
        string tree = string.Concat(names.Select(static (name, number) => $"{(number == 0 ? "ROOT" : "JOINT")} {name}\n{{\nOFFSET 0 1 0\nCHANNELS 3 Zrotation Yrotation Xrotation\n"));
        string row = string.Join(' ', Enumerable.Repeat("0", 3 * names.Length));
        Folder.Write("chain.bvh", $"HIERARCHY\n{tree}End Site\n{{\nOFFSET 0 1 0\n}}\n{new string('}', names.Length).Replace("}", "}\n", StringComparison.Ordinal)}MOTION\nFrames: 1\nFrame Time: 0.01\n{row}\n");
        JsonElement skeleton = (await JsonAsync("chain.bvh")).GetProperty("skeleton");
        Assert.Equal(names, skeleton.GetProperty("jointNames").EnumerateArray().Select(static name => name.GetString()));
        Assert.Contains(await PageAsync("chain.bvh"), static line => line.Contains("joint0, joint1", StringComparison.Ordinal) && line.Contains('…', StringComparison.Ordinal));
    }

    [Fact]
    public async Task Oddities_are_found()
    {
        // A T-pose first, then arms down. The head's angles jump by half a turn without a movement. One value is not a number.
        BvhDocument take = Takes.Neuron(
            40,
            static (frame, pose) =>
            {
                if (frame > 0)
                    pose[(int)Bone.LeftArm] = pose[(int)Bone.LeftArm] with { Rotation = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, -1.2f) };

                pose[(int)Bone.LeftHand] = pose[(int)Bone.LeftHand] with { Position = pose[(int)Bone.LeftHand].Position + new Vector3(frame * 0.02f, 0, 0) };
            },
            displacement: true);
        var layout = new ChannelLayout(hasDisplacement: true, hasReference: false);
        float[] values = [.. Enumerable.Range(0, take.FrameCount).SelectMany(frame => take.GetValues(frame).ToArray())];
        int head = layout.GetRotationIndex(Bone.Head);
        for (int frame = 20; frame < 40; frame++)
            (values[(frame * 354) + head], values[(frame * 354) + head + 1], values[(frame * 354) + head + 2]) = (180, 180, 180);

        values[(30 * 354) + layout.GetRotationIndex(Bone.RightHand)] = float.NaN;
        new BvhDocument(take.Hierarchy, take.FrameTime, values).Save(Folder["odd.bvh"]);
        JsonElement[] oddities = [.. (await JsonAsync("odd.bvh")).GetProperty("oddities").EnumerateArray()];

        Assert.Contains(oddities, static oddity => Is(oddity, "restPose"));
        Assert.Contains("Head 1", Text(oddities, "flips"), StringComparison.Ordinal);
        Assert.Contains("0.33 s", Text(oddities, "flips"), StringComparison.Ordinal);
        Assert.Contains("frame 30", Text(oddities, "notNumbers"), StringComparison.Ordinal);
        Assert.Contains("0.78 cm at most (LeftHand at 0.65 s)", Text(oddities, "displacement"), StringComparison.Ordinal);
        Assert.Contains("of the 354 values never change", Text(oddities, "constantColumns"), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Repairs_have_their_place()
    {
        Folder.Write("bad.bvh", Takes.TwoJoints.Replace("Frames: 3", "Frames: 9", StringComparison.Ordinal));
        JsonElement oddity = (await JsonAsync("bad.bvh")).GetProperty("oddities").EnumerateArray().First();
        Assert.Equal("repair", oddity.GetProperty("code").GetString());
        Assert.Equal(17, oddity.GetProperty("line").GetInt32());
        Assert.True(oddity.GetProperty("column").GetInt32() > 0);
    }

    [Fact]
    public async Task Joints_that_are_not_bones_are_named()
    {
        Folder.Write("robot.bvh", Takes.Robot(Takes.Actor(20)));
        JsonElement skeleton = (await JsonAsync("robot.bvh")).GetProperty("skeleton");
        Assert.Equal("Neck1", skeleton.GetProperty("variant").GetString());
        Assert.Equal(["Prop1"], skeleton.GetProperty("otherJoints").EnumerateArray().Select(static name => name.GetString()));
        Assert.Contains(await PageAsync("robot.bvh"), static line => line.Contains("other joints", StringComparison.Ordinal) && line.Contains("Prop1: only BVH files keep them", StringComparison.Ordinal));

        Takes.Actor(20).Save(Folder["actor.bvh"]);
        Assert.Equal(0, (await JsonAsync("actor.bvh")).GetProperty("skeleton").GetProperty("otherJoints").GetArrayLength());
        Assert.DoesNotContain(await PageAsync("actor.bvh"), static line => line.Contains("other joints", StringComparison.Ordinal));
    }

    [Fact]
    public async Task Another_skeleton_is_described()
    {
        Folder.Write("joints.bvh", Takes.TwoJoints);
        string[] page = await PageAsync("joints.bvh");

        Assert.Equal("2, 1 End Site, 2 deep, from base", Fact(page, "joints"));
        Assert.Contains("Hips", Fact(page, "not Neuron's"), StringComparison.Ordinal);
        Assert.Equal("ZYX (1 joint), X (1 joint)", Fact(page, "rotation order"));
        Assert.StartsWith("2.00 by 0.00 units of the file", Fact(page, "extent"), StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_skeleton_without_frames_is_described()
    {
        Folder.Write("empty.bvh", Takes.TwoJoints[..Takes.TwoJoints.IndexOf("MOTION", StringComparison.Ordinal)]);
        Assert.Contains("  a skeleton without frames", await PageAsync("empty.bvh"));
        ToolResult plot = await ToolRunner.RunAsync("plot", Folder["empty.bvh"], Folder["empty.svg"]);
        Assert.Equal(1, plot.ExitCode);
    }

    [Fact]
    public async Task A_frame_time_of_zero_is_one_oddity()
    {
        Folder.Write("zero.bvh", Takes.TwoJoints.Replace("0.04", "0", StringComparison.Ordinal));
        JsonElement oddities = (await JsonAsync("zero.bvh")).GetProperty("oddities");
        Assert.Single(oddities.EnumerateArray(), static oddity => oddity.GetProperty("text").GetString()!.Contains("frame time", StringComparison.Ordinal));
    }

    private static bool Is(JsonElement oddity, string code) => oddity.GetProperty("code").ValueEquals(code);

    private static string Text(JsonElement[] oddities, string code) => oddities.Single(oddity => Is(oddity, code)).GetProperty("text").GetString()!;
}
