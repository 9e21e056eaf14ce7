using NeuronMocap.Tool.Tests.Infrastructure;
using NeuronMocap.Tool.Watch.Live;

namespace NeuronMocap.Tool.Tests.Watch.Live;

public sealed class SkeletonViewTests
{
    private const int Columns = 41;
    private const int Rows = 20;

    [Fact]
    public void The_arms_of_a_T_pose_reach_to_both_sides_and_the_head_is_above_them()
    {
        int[] widths = [.. Draw(Poses.Upright(), Viewpoint.Front).Select(row => row.TrimEnd('\u2800').Length - row.Length + row.TrimStart('\u2800').Length)];

        int arms = Array.IndexOf(widths[..^2], widths[..^2].Max());
        Assert.True(widths[arms] > Columns * 3 / 4, $"The arms take {widths[arms]} of {Columns} columns.");
        Assert.True(arms > 1, "Nothing is above the arms.");
        Assert.All(widths[1..arms], width => Assert.True(width < Columns / 4, $"The head is {width} columns wide."));
    }

    [Fact]
    public void From_the_side_the_arms_are_short()
    {
        string[] rows = Draw(Poses.Upright(), Viewpoint.Side);
        Assert.All(rows[1..^3], row => Assert.True(row.Trim('\u2800').Length < Columns / 3, row));
    }

    [Fact]
    public void The_view_follows_the_hips_while_the_ground_stands_still()
    {
        string[] here = Draw(Poses.Upright(), Viewpoint.Front);
        string[] there = Draw(Poses.Upright(x: 130), Viewpoint.Front);

        Assert.Equal(here[1..^3], there[1..^3]);
        Assert.NotEqual(here[^2..], there[^2..]);
    }

    [Fact]
    public void The_scale_grows_with_what_it_has_seen_and_does_not_shrink()
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
    public void Values_that_no_body_has_do_not_change_the_scale()
    {
        var scale = new ViewScale();
        float reach = scale.Reach;
        scale.Include([default, new(float.NaN, float.NaN, 0), new(1e9f, -1e9f, float.PositiveInfinity)]);
        Assert.Equal(reach, scale.Reach);
    }

    [Fact]
    public void Every_bone_is_drawn_and_head_feet_and_fingers_have_ends()
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
