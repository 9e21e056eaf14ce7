using System.Diagnostics;
using NeuronMocap.Tool.Tests.Infrastructure;
using NeuronMocap.Tool.Watch.Live;
using static NeuronMocap.Tool.Tests.Watch.Live.DashboardScreen;

namespace NeuronMocap.Tool.Tests.Watch.Live;

public sealed class DashboardAvatarTests
{
    [Fact]
    public void More_avatars_than_rows_are_counted()
    {
        string text = string.Join('\n', Draw(WithManyAvatars(), 80, 24));
        Assert.Contains("and 17 more", text, StringComparison.Ordinal);
    }

    [Fact]
    public void Reduced_frequency_gaps_and_restarts_are_shown()
    {
        LiveState state = State(Receiving);
        state.Counters.Take(default, [new AvatarStatistics
        {
            AvatarName = "Char00", FrameRate = 30, FrequencyReduction = 2, Gaps = 41, Restarts = 43, LastTimestamp = state.Now,
        }]);

        Assert.Contains("30.0/2", string.Concat(Draw(state, 80, 24)), StringComparison.Ordinal);
        string wide = string.Concat(Draw(state, 140, 40));
        foreach (string part in (string[])["30.0/2", "gaps", "41", "restarts", "43"])
            Assert.Contains(part, wide, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(80, " late ")]
    [InlineData(100, " out of order ")]
    public void The_column_of_frames_out_of_order_has_a_whole_title(int width, string title) =>
        Assert.Contains(title, string.Concat(Draw(WithPose(), width, 24)), StringComparison.Ordinal);

    [Fact]
    public void The_help_explains_frames_out_of_order() =>
        Assert.Matches("out of order +frames that arrived twice", string.Join('\n', Draw(WithHelp(), 120, 80)));

    [Theory]
    [InlineData(40, 12)]
    [InlineData(80, 24)]
    [InlineData(200, 60)]
    public void A_name_from_the_network_cannot_control_the_terminal(int width, int height)
    {
        LiveState state = State(Receiving);
        state.Counters.Take(default, [new AvatarStatistics { AvatarName = "\e[2J\u202Eevil\u009b\u200B\u2066", LastTimestamp = state.Now }]);
        string text = string.Concat(Draw(state, width, height));
        Assert.Contains("evil", text, StringComparison.Ordinal);
        Assert.Equal(-1, text.IndexOfAny(['\e', '\u009b', '\u202E', '\u200B', '\u2066']));
    }

    [Fact]
    public void Standing_feet_are_letters_and_raised_feet_are_dots()
    {
        // A foot counts as planted if it is where it was a frame before.
        LiveState state = WithPose();
        state.Take(Poses.Upright(index: 1));
        string none = string.Join('\n', Draw(state, 80, 24));
        string colours = string.Join('\n', Draw(state, 80, 24, isColoured: true));

        Assert.Matches("L R *\n", none);
        Assert.Contains("\e[", colours, StringComparison.Ordinal);
        Assert.Matches("L.*R", WithoutColours(colours));

        // Half a metre above the ground, no foot touches it.
        state.Take(Poses.Upright(index: 2, height: 50));
        Assert.Matches("· · *\n", string.Join('\n', Draw(state, 80, 24)));
    }

    [Fact]
    public void Standing_feet_have_a_letter_on_the_ground_line()
    {
        LiveState state = WithPose();
        state.BonePage = -1;
        state.Take(Poses.Upright(index: 1));
        string ground = Draw(state, 40, 24).Last(static line => line.Contains('L', StringComparison.Ordinal));
        Assert.Matches("R.*L.*RL|R.*L.*LR|R.*L.*L", ground);

        state.Take(Poses.Upright(index: 2, height: 50));
        Assert.DoesNotContain(Draw(state, 40, 24), static line => line.Contains('⠤', StringComparison.Ordinal) && line.Contains('L', StringComparison.Ordinal));
    }

    [Theory]
    [InlineData(40, 12, 2)]
    [InlineData(80, 24, 2)]
    [InlineData(132, 43, 3)]
    public void Several_avatars_stand_side_by_side(int width, int height, int expected)
    {
        LiveState state = WithThreePeople();
        string captions = Draw(state, width, height).Single(static line => line.Contains("front", StringComparison.Ordinal));
        Assert.Equal(expected, captions.Split("front").Length - 1);
        Assert.Contains("> 0 Actor0 front", captions, StringComparison.Ordinal);
        Assert.Contains("  1 Actor1 front", captions, StringComparison.Ordinal);

        // The last avatar comes into view when it is selected, in the drawing and in the table.
        state.SelectNextAvatar();
        state.SelectNextAvatar();
        string[] lines = Draw(state, width, height);
        Assert.Equal(2, lines.Count(static line => line.Contains("> 2 Actor2", StringComparison.Ordinal)));
        Assert.Equal(2, state.Selected?.Avatar);
    }

    [Fact]
    public void The_table_of_bones_makes_room_for_avatars()
    {
        LiveState state = WithThreePeople();
        state.BonePage = -1;
        string text = string.Join('\n', Draw(state, 80, 24));
        Assert.DoesNotContain("bones:", text, StringComparison.Ordinal);
        Assert.Contains("  2 Actor2 front", text, StringComparison.Ordinal);
    }

    [Fact]
    public void A_silent_avatar_is_marked()
    {
        LiveState state = WithPose();
        state.TakenAt += 100 * Stopwatch.Frequency;
        Assert.Contains("no data for 1 min", string.Concat(Draw(state, 100, 30)), StringComparison.Ordinal);
    }

    [Fact]
    public void The_colour_legend_needs_colours()
    {
        Assert.DoesNotContain("■ left", string.Concat(Draw(WithPose(), 80, 24)), StringComparison.Ordinal);
        Assert.Contains("■ left", WithoutColours(string.Concat(Draw(WithPose(), 80, 24, isColoured: true))), StringComparison.Ordinal);
    }
}
