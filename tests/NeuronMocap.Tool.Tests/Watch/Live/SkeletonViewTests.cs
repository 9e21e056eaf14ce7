using NeuronMocap.Tool.Figures;
using NeuronMocap.Tool.Tests.Infrastructure;
using NeuronMocap.Tool.Watch.Live;

namespace NeuronMocap.Tool.Tests.Watch.Live;

public sealed class SkeletonViewTests
{
    private const int Columns = 41;
    private const int Rows = 20;

    [Fact]
    public void A_T_pose_has_its_arms_out_and_its_head_above()
    {
        int[] widths = [.. Draw(Poses.Upright(), Viewpoint.Front).Select(row => row.TrimEnd('\u2800').Length - row.Length + row.TrimStart('\u2800').Length)];

        int arms = Array.IndexOf(widths[..^2], widths[..^2].Max());
        Assert.True(widths[arms] > Columns * 3 / 4, $"The arms take {widths[arms]} of {Columns} columns.");
        Assert.True(arms > 1, "Nothing is above the arms.");
        Assert.All(widths[1..arms], width => Assert.True(width < Columns / 4, $"The head is {width} columns wide."));
    }

    [Fact]
    public void Arms_are_short_in_the_side_view()
    {
        string[] rows = Draw(Poses.Upright(), Viewpoint.Side);
        Assert.All(rows[1..^3], row => Assert.True(row.Trim('\u2800').Length < Columns / 3, row));
    }

    [Fact]
    public void The_view_follows_the_hips_above_fixed_ground()
    {
        string[] here = Draw(Poses.Upright(), Viewpoint.Front);
        string[] there = Draw(Poses.Upright(x: 130), Viewpoint.Front);

        Assert.Equal(here[1..^3], there[1..^3]);
        Assert.NotEqual(here[^2..], there[^2..]);
    }

    [Fact]
    public void The_scale_only_grows()
    {
        var scale = new ViewScale();
        var pose = new Pose(Poses.Upright());
        scale.Include(pose.Points);
        float reach = scale.Reach;

        scale.Include(pose.Points[..1]);

        Assert.Equal(reach, scale.Reach);
        Assert.InRange(reach, 80, 110);
        Assert.Equal(0, reach % 10);
    }

    [Fact]
    public void Impossible_values_do_not_change_the_scale()
    {
        var scale = new ViewScale();
        float reach = scale.Reach;
        scale.Include([default, new(float.NaN, float.NaN, 0), new(1e9f, -1e9f, float.PositiveInfinity)]);
        Assert.Equal(reach, scale.Reach);
    }

    [Fact]
    public void Every_bone_and_end_site_is_drawn()
    {
        Assert.Equal(58 + 13, Wireframe.Lines(Skeleton.SkeletonVariant.Neck1).Length);
        Assert.Equal(58 + 13, Wireframe.Lines(Skeleton.SkeletonVariant.Spine3).Length);
    }

    private static string[] Draw(MotionFrame frame, Viewpoint viewpoint)
    {
        var scale = new ViewScale();
        var pose = new Pose(frame);
        scale.Include(pose.Points);
        BrailleCanvas canvas = SkeletonView.Draw(pose, feet: null, viewpoint, scale, Columns, Rows);
        return [.. Enumerable.Range(0, Rows).Select(canvas.GetRow)];
    }
}
