using System.Numerics;
using NeuronMocap.Gltf;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Gltf;
using NeuronMocap.Tool.Tests.Files;
using static NeuronMocap.Tool.Tests.Convert.Conversion;

namespace NeuronMocap.Tool.Tests.Convert;

/// <summary>Other programs read our GLB files, without a complaint and with the joints where we have them.</summary>
public sealed class GlbProgramsTests : IDisposable
{
    // In millimetres.
    private const float SamePlace = 0.1f;

    private static readonly double[] Times = [0, 0.5, 1, 119 / 60.0];

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task The_validator_has_nothing_to_say_and_three_js_has_our_joints()
    {
        Takes.Actor(120).Save(_folder["take.bvh"]);
        await ConvertAsync(_folder["take.bvh"], _folder["take.glb"]);
        await ConvertAsync(_folder["take.bvh"], _folder["few.glb"], "--resample", "30", "--key-error", "1");
        WriteTwo(_folder["two.glb"]);

        GlbChecker.Report[] reports = await GlbChecker.CheckAsync([_folder["take.glb"], _folder["two.glb"], _folder["few.glb"]], Times);

        Assert.All(reports, static report => Assert.Empty(report.Issues));
        Assert.Equal([1, 2, 1], reports.Select(static report => report.Figures.Length));
        Assert.Equal(["Anna/😀", "Anna/😀 (2)"], reports[1].Figures[0].Clips);
        AssertJoints(0, reports[0].Figures[0]);
        AssertJoints(0, reports[1].Figures[0]);
        AssertJoints(100, reports[1].Figures[1]);
        Assert.InRange(reports[0].Figures[0].Size.Y, 1.4f, 1.8f);
    }

    [Fact]
    public async Task The_validator_accepts_what_comes_from_hostile_takes()
    {
        SkeletonBody broken = new(new Vector3[BoneHierarchy.BoneCount], new Vector3[BoneHierarchy.BoneCount]);
        string[] files =
        [
            Write("none.glb", null, static _ => { }),
            Write("rest.glb", null, static writer => writer.AddAvatar(string.Empty, GlbTake.Body)),
            Write("one.glb", null, static writer => GlbTake.WriteFrames(writer.AddAvatar("\ud83d\u0001\"\\/", GlbTake.Body), 1)),
            Write("points.glb", null, writer => GlbTake.WriteFrames(writer.AddAvatar("Hips", broken), 10)),
            Write("spine3.glb", null, static writer => GlbTake.WriteFrames(writer.AddAvatar("Anna", SkeletonBody.GetDefault(SkeletonVariant.Spine3)), 10)),
            Write("gap.glb", new GlbOptions { RotationTolerance = 2 }, static writer =>
            {
                GlbAvatar avatar = writer.AddAvatar("Anna", GlbTake.Body);
                GlbTake.WriteFrames(avatar, 20);
                GlbTake.WriteFrames(avatar, 20, first: 60 * 3600);
            }),
            Write("broken.glb", null, static writer =>
            {
                GlbAvatar avatar = writer.AddAvatar("Anna", GlbTake.Body);
                avatar.WriteFrame(TimeSpan.Zero, new BoneTransform[BoneHierarchy.BoneCount]);
                avatar.WriteFrame(TimeSpan.Zero, GlbTake.Pose(0));
                var pose = Enumerable.Repeat(new BoneTransform(new Vector3(float.NaN), new Quaternion(float.NaN, 0, 0, 0)), BoneHierarchy.BoneCount).ToArray();
                avatar.WriteFrame(TimeSpan.FromSeconds(1), pose);
                avatar.WriteFrame(TimeSpan.MaxValue, GlbTake.Pose(1));
            }),
        ];

        GlbChecker.Report[] reports = await GlbChecker.CheckAsync(files, [0, 0.1]);

        foreach ((string file, GlbChecker.Report report) in files.Zip(reports))
            Assert.True(report.Issues.Length == 0, $"{Path.GetFileName(file)}: {string.Join('\n', report.Issues)}");
    }

    [Fact]
    public async Task Blender_has_our_joints()
    {
        WriteTwo(_folder["two.glb"]);

        Dictionary<string, Dictionary<string, Vector3>[]> armatures = await GlbChecker.ImportAsync(_folder["two.glb"], GlbTake.Rate, Times);

        Assert.Equal(["Anna/😀", "Anna/😀 (2)"], armatures.Keys.Order(StringComparer.Ordinal));
        foreach ((string name, int first) in (ValueTuple<string, int>[])[("Anna/😀", 0), ("Anna/😀 (2)", 100)])
        {
            for (int time = 0; time < Times.Length; time++)
            {
                Dictionary<string, Vector3> found = armatures[name][time];
                Assert.InRange(GlbTake.Distance(JointsAt(first, time), [.. BoneHierarchy.Bones.ToArray().Select(bone => found[BoneHierarchy.GetName(bone)])]), 0, SamePlace);
            }
        }
    }

    private static void AssertJoints(int first, GlbChecker.Figure figure)
    {
        Assert.Equal(BoneHierarchy.Bones.ToArray().Select(static bone => BoneHierarchy.GetName(bone)), figure.Names);
        for (int time = 0; time < Times.Length; time++)
            Assert.InRange(GlbTake.Distance(JointsAt(first, time), figure.Joints[time]), 0, SamePlace);
    }

    private static Vector3[] JointsAt(int first, int time) => GlbTake.Joints(GlbTake.Pose(first + (long)Math.Round(Times[time] * GlbTake.Rate)));

    private string Write(string name, GlbOptions? options, Action<GlbWriter> write)
    {
        File.WriteAllBytes(_folder[name], GlbTake.WriteBytes(options, write));
        return _folder[name];
    }

    private static void WriteTwo(string path)
    {
        using var writer = new GlbWriter(path);
        foreach (int first in (int[])[0, 100])
        {
            GlbAvatar avatar = writer.AddAvatar("Anna/😀", GlbTake.Body);
            for (int frame = 0; frame < 120; frame++)
                avatar.WriteFrame(GlbTake.Time(frame), GlbTake.Pose(first + frame));
        }
    }
}
