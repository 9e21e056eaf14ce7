using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Tests.Files;
using NeuronMocap.Tool.Tests.Infrastructure;
using static NeuronMocap.Tool.Tests.Convert.Conversion;

namespace NeuronMocap.Tool.Tests.Convert;

/// <summary>Tables of poses, compared with the kinematics of the take.</summary>
public sealed class CsvTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData(".bvh")]
    [InlineData(".nmrec")]
    [InlineData(".bin")]
    public async Task A_table_has_the_joints_of_the_take(string kind)
    {
        BvhDocument take = Takes.Actor(60, order: RotationOrder.ZXY);
        take.Save(_folder["source.bvh"]);
        if (kind != ".bvh")
            await ConvertAsync(_folder["source.bvh"], _folder["source" + kind]);

        string[] options = kind == ".bin" ? ["--rate", "60", "--order", "ZXY"] : [];
        string summary = await ConvertAsync(_folder["source" + kind], _folder["t.csv"], options);
        Assert.Contains(": 60 frames, ", summary, StringComparison.Ordinal);
        Assert.Contains("no gaps; no rows left out; no warnings", summary, StringComparison.Ordinal);

        var table = new CsvTable(_folder["t.csv"]);
        AssertJoints(take, table, static position => position / 100, static rotation => rotation);
        for (int row = 0; row < 60; row++)
            Assert.Equal(row / 60.0, table.Number(row, "time"), 1e-6);

        Assert.Contains("# rate: 60 frames per second", table.Comments);
        Assert.Contains("# rotation order of the source: ZXY", table.Comments);
        Assert.Contains("# source: source" + kind, table.Comments);
        Assert.Equal(kind == ".nmrec", table.Text(0, "arrival").Length > 0);
    }

    [Fact]
    public async Task Axes_and_unit_are_options()
    {
        BvhDocument take = Takes.Actor(5);
        take.Save(_folder["a.bvh"]);
        await ConvertAsync(_folder["a.bvh"], _folder["a.csv"], "--up", "z", "--unit", "cm");
        var table = new CsvTable(_folder["a.csv"]);

        // The same rotation, computed in another way: the axes turn by 120 degrees about their diagonal.
        var turn = Quaternion.CreateFromAxisAngle(Vector3.Normalize(Vector3.One), MathF.PI * 2 / 3);
        AssertJoints(take, table, position => Vector3.Transform(position, turn), rotation => turn * rotation * Quaternion.Conjugate(turn));
        Assert.True(table.Number(0, "Head_z") > 100, "The head is not above the ground.");
        Assert.Contains(table.Comments, static line => line.EndsWith("in centimetres", StringComparison.Ordinal));
        Assert.Contains(table.Comments, static line => line.Contains("x forward, y to the left, z up", StringComparison.Ordinal));
    }

    [Fact]
    public async Task Parts_and_rates_are_those_of_other_files()
    {
        Takes.Actor(120).Save(_folder["a.bvh"]);
        await ConvertAsync(_folder["a.bvh"], _folder["a.nmrec"]);
        foreach (string input in (string[])["a.bvh", "a.nmrec"])
        {
            await ConvertAsync(_folder[input], _folder["part.csv"], "--from", "0.5", "--to", "1", "--overwrite");
            await ConvertAsync(_folder[input], _folder["slow.csv"], "--resample", "30", "--overwrite");
            await ConvertAsync(_folder["a.bvh"], _folder["all.csv"], "--overwrite");
            var part = new CsvTable(_folder["part.csv"]);
            var slow = new CsvTable(_folder["slow.csv"]);
            var all = new CsvTable(_folder["all.csv"]);
            Assert.Equal((30, 60), (part.RowCount, slow.RowCount));
            Assert.Equal(0, part.Number(0, "time"), 1e-6);
            Assert.Equal(all.Position(30, "Head"), part.Position(0, "Head"));
            Assert.Equal(all.Position(118, "Head"), slow.Position(59, "Head"));
            Assert.Equal(59 / 30.0, slow.Number(59, "time"), 1e-6);
        }
    }

    [Fact]
    public async Task Calculation_exports_become_tables()
    {
        BvhDocument take = Takes.Actor(60);
        take.Save(_folder["a.bvh"]);
        await ConvertAsync(_folder["a.bvh"], _folder["a.calc"]);
        await ConvertAsync(_folder["a.calc"], _folder["a.nmrec"]);
        await ConvertAsync(_folder["a.calc"], _folder["pose.bvh"]);
        foreach (string input in (string[])["a.calc", "a.nmrec"])
        {
            await ConvertAsync(_folder[input], _folder["a.csv"], "--overwrite");
            var table = new CsvTable(_folder["a.csv"]);
            AssertJoints(BvhDocument.Load(_folder["pose.bvh"]), table, static position => position / 100, static rotation => rotation, 2e-3f);
            Assert.DoesNotContain(table.Comments, static line => line.Contains("rotation order", StringComparison.Ordinal));
        }
    }

    [Theory]
    [InlineData("a.bvh", "--output-order", "XYZ", 1)]
    [InlineData("a.bvh", "--order", "XYZ", 1)]
    [InlineData("a.bvh", "--avatar", "0", 1)]
    [InlineData("a.bvh", "--from", "9", 1)]
    [InlineData("a.nmrec", "--from", "9", 1)]
    [InlineData("a.nmrec", "--avatar", "1", 1)]
    [InlineData("a.bvh", "--up", "x", 2)]
    [InlineData("a.bvh", "--unit", "inch", 2)]
    public async Task What_a_table_cannot_hold_is_refused(string input, string option, string value, int code)
    {
        Takes.Actor(10).Save(_folder["a.bvh"]);
        await ConvertAsync(_folder["a.bvh"], _folder["a.nmrec"]);
        ToolResult result = await ToolRunner.RunAsync("convert", _folder[input], _folder["a.csv"], option, value);
        Assert.Equal(code, result.ExitCode);
        string error = Assert.Single(result.Error);
        Assert.True(error.Contains(option, StringComparison.Ordinal) || error.Contains("No frames remain", StringComparison.Ordinal) || error.Contains("avatar 1", StringComparison.Ordinal), error);
        Assert.DoesNotContain("--output-order sets", error, StringComparison.Ordinal);
        Assert.Equal(["a.bvh", "a.nmrec"], _folder.Names);
    }

    [Fact]
    public async Task Options_of_tables_are_refused_for_other_files_and_a_table_is_not_an_input()
    {
        Takes.Actor(10).Save(_folder["a.bvh"]);
        ToolResult other = await ToolRunner.RunAsync("convert", _folder["a.bvh"], _folder["b.bvh"], "--up", "z");
        Assert.Equal(2, other.ExitCode);
        Assert.Contains("--up is for .csv files", Assert.Single(other.Error), StringComparison.Ordinal);

        await ConvertAsync(_folder["a.bvh"], _folder["a.csv"]);
        ToolResult again = await ToolRunner.RunAsync("convert", _folder["a.bvh"], _folder["a.csv"]);
        Assert.Contains("--overwrite", Assert.Single(again.Error), StringComparison.Ordinal);
        ToolResult back = await ToolRunner.RunAsync("convert", _folder["a.csv"], _folder["b.bvh"]);
        Assert.Equal((1, 1), (again.ExitCode, back.ExitCode));
        Assert.Contains("a.csv", Assert.Single(back.Error), StringComparison.Ordinal);
        Assert.Equal(["a.bvh", "a.csv"], _folder.Names);
    }

    private static void AssertJoints(
        BvhDocument take, CsvTable table, Func<Vector3, Vector3> position, Func<Quaternion, Quaternion> rotation, float tolerance = 1e-4f)
    {
        var source = new BvhSource(take);
        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        Assert.Equal(take.FrameCount, table.RowCount);
        for (int row = 0; row < table.RowCount; row++)
        {
            Assert.Equal((0, row), (table.Number(row, "avatar"), table.Number(row, "frame")));
            source.GetPose(row, pose);
            ForwardKinematics.ToWorld(pose, pose, source.Variant);
            foreach (Bone bone in BoneHierarchy.Bones)
            {
                string name = BoneHierarchy.GetName(bone, source.Variant);
                Assert.InRange(Vector3.Distance(position(pose[(int)bone].Position), table.Position(row, name)), 0, tolerance);
                Assert.InRange(MathF.Abs(Quaternion.Dot(rotation(pose[(int)bone].Rotation), table.Rotation(row, name))), 1 - tolerance, 1 + tolerance);
            }
        }
    }
}
