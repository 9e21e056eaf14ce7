using System.Diagnostics;
using System.Text.RegularExpressions;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Tests.Infrastructure;
using NeuronMocap.Tool.Watch;
using NeuronMocap.Tool.Watch.Live;
using Spectre.Console;

namespace NeuronMocap.Tool.Tests.Watch.Live;

public sealed partial class DashboardTests
{
    private static readonly ConnectionStatus Receiving = new(ConnectionState.Receiving, ConnectionReason.None, "Receiving from studio:7001.");

    private static readonly ConnectionStatus Refused = new(ConnectionState.Waiting, ConnectionReason.Refused, "Nothing listens there. Check the port.")
    {
        Attempt = 2,
        RetryIn = TimeSpan.FromSeconds(3),
    };

    public static TheoryData<int, int> Sizes => new() { { 1, 5 }, { 20, 5 }, { 40, 12 }, { 50, 15 }, { 60, 16 }, { 80, 24 }, { 99, 31 }, { 100, 32 }, { 120, 40 }, { 200, 50 }, { 400, 120 } };

    [Theory]
    [MemberData(nameof(Sizes))]
    public void It_fits_every_window_in_every_state(int width, int height)
    {
        foreach (LiveState state in (LiveState[])[State(Refused), State(Receiving), WithPose(), WithManyAvatars(), WithHelp()])
        {
            string[] lines = Draw(state, width, height);
            Assert.InRange(lines.Length, 1, height);
            Assert.All(lines, line => Assert.True(line.Length <= width, line));
        }
    }

    [Theory]
    [InlineData(80, 24)]
    [InlineData(120, 40)]
    public void A_missing_connection_is_shown_with_its_reason_and_what_to_do(int width, int height)
    {
        string text = string.Join('\n', Draw(State(Refused), width, height));

        Assert.Contains("CONNECTION REFUSED", text, StringComparison.Ordinal);
        Assert.Contains("Nothing listens there. Check the port.", text, StringComparison.Ordinal);
        Assert.Contains("attempt 2 failed, next in", text, StringComparison.Ordinal);
    }

    [Fact]
    public void The_small_view_shows_stream_counters_both_drawings_and_bones()
    {
        string text = string.Join('\n', Draw(WithPose(), 80, 24));

        foreach (string part in (string[])["RECEIVING", "TCP studio:7001", "1.1.0.0 NEW", "180 values", "YXZ assumed", "> 0 Char00", "front", "side", "R.Foot", "q quit"])
            Assert.Contains(part, text, StringComparison.Ordinal);

        Assert.Contains("84.1", text, StringComparison.Ordinal);
    }

    // Also where the columns that are not essential have no room.
    [Theory]
    [InlineData(60, 16)]
    [InlineData(71, 20)]
    [InlineData(72, 20)]
    [InlineData(95, 24)]
    public void Every_width_that_is_allowed_shows_the_avatars_and_their_rates(int width, int height)
    {
        string text = string.Join('\n', Draw(WithPose(), width, height));
        foreach (string part in (string[])["avatar", "> 0 Char00", "84.1"])
            Assert.Contains(part, text, StringComparison.Ordinal);
    }

    [Fact]
    public void More_avatars_than_rows_are_counted()
    {
        string text = string.Join('\n', Draw(WithManyAvatars(), 80, 24));
        Assert.Contains("and 17 more", text, StringComparison.Ordinal);
    }

    [Fact]
    public void Frequency_reducing_gaps_and_restarts_are_shown_where_there_is_room()
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
    [InlineData(60, 16)]
    [InlineData(80, 24)]
    [InlineData(140, 40)]
    [InlineData(40, 12)]
    public void A_file_that_cannot_be_written_any_more_is_told_with_its_reason(int width, int height)
    {
        LiveState state = WithPose();
        state.AddFailure(new FileFailure("recording", "take.nmrec", "the disk is full.", 7, 0));
        Assert.Contains("RECORDING FAILED: the disk is full.", string.Concat(Draw(state, width, height)), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(80, 24)]
    [InlineData(140, 40)]
    public void Two_files_that_failed_are_both_told_and_the_status_stays(int width, int height)
    {
        LiveState state = WithPose();
        state.AddFailure(new FileFailure("recording", "take.nmrec", "the disk is full.", 7, 0));
        state.AddFailure(new FileFailure("export", "take.bvh", "the disk is full.", 7, 0));
        string[] lines = Draw(state, width, height);
        string text = string.Concat(lines);
        foreach (string part in (string[])["RECORDING FAILED: the disk is full.", "EXPORT FAILED: the disk is full.", "Receiving from studio:7001."])
            Assert.Contains(part, text, StringComparison.Ordinal);

        // In the events as well, with their time.
        Assert.Equal(2, lines.Count(static line => line.Contains("● ", StringComparison.Ordinal) && line.Contains(" failed: the disk", StringComparison.Ordinal)));
    }

    // The sentence above that line says where the order is from.
    [Fact]
    public void The_stream_line_does_not_contradict_the_command_channel()
    {
        var state = new LiveState(new WatchOptions { Server = new ServerAddress("studio", 7001), CommandPort = 8013 })
        {
            Status = new(ConnectionState.Receiving, ConnectionReason.None, "Receiving from studio:7001: binary format; rotation order YXZ, as the command channel says."),
        };
        state.Take(Poses.Upright());
        string text = string.Concat(Draw(state, 100, 30));
        Assert.Contains("YXZ, as the command channel says", text, StringComparison.Ordinal);
        Assert.DoesNotContain("assumed", text, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(40, 12)]
    [InlineData(80, 24)]
    [InlineData(200, 60)]
    public void A_name_from_the_network_cannot_command_the_terminal(int width, int height)
    {
        LiveState state = State(Receiving);
        state.Counters.Take(default, [new AvatarStatistics { AvatarName = "\e[2J\u202Eevil\u009b\u200B\u2066", LastTimestamp = state.Now }]);
        string text = string.Concat(Draw(state, width, height));
        Assert.Contains("evil", text, StringComparison.Ordinal);
        Assert.Equal(-1, text.IndexOfAny(['\e', '\u009b', '\u202E', '\u200B', '\u2066']));
    }

    // The sentences of the library that are longest; the setting to change stands at their end.
    [Theory]
    [InlineData(40, 12)]
    [InlineData(50, 15)]
    [InlineData(60, 16)]
    [InlineData(80, 24)]
    [InlineData(200, 60)]
    public void The_sentence_that_explains_a_problem_is_shown_whole(int width, int height)
    {
        foreach (ConnectionStatus problem in (ConnectionStatus[])
        [
            new(ConnectionState.Silent, ConnectionReason.NoData, "Connected to 192.168.100.200:7001, but nothing has arrived for 3 s. In Axis Neuron, connect the suit or play a take, and check that broadcasting of BVH or calculation data is on, and that this is its port and not that of commands."),
            new(ConnectionState.Waiting, ConnectionReason.Refused, "192.168.100.200:7001 refused the connection: nothing listens there. In Axis Neuron's broadcasting settings switch BVH on, choose TCP, and check that the port is the same.") { Attempt = 2, RetryIn = TimeSpan.FromSeconds(3) },
            new(ConnectionState.Silent, ConnectionReason.SenderNotAllowed, "Datagrams arrive on UDP port 7012, but none from a sender that AllowedSenders lists. They come from 192.168.1.20. Give AllowedSenders the address of the computer that runs Axis Neuron, or leave it out to let everyone send."),
        ])
        {
            Assert.Contains(problem.Describe(), Words(Draw(State(problem), width, height)), StringComparison.Ordinal);
            LiveState late = WithPose();
            late.Status = problem;
            Assert.Contains(problem.Describe(), Words(Draw(late, width, height)), StringComparison.Ordinal);
        }
    }

    [Theory]
    [InlineData(40, 12)]
    [InlineData(50, 15)]
    [InlineData(60, 16)]
    [InlineData(80, 24)]
    [InlineData(200, 60)]
    public void What_is_wrong_with_frames_that_arrive_is_shown_whole(int width, int height)
    {
        LiveState state = WithPose();
        state.Status = new(
            ConnectionState.Receiving,
            ConnectionReason.RotationOrderMismatch,
            "Receiving from studio:7001: binary format of Axis Studio; rotation order XYZ, as the options say. But the stream says YXZ: one of them is wrong. Leave RotationOrder out to use YXZ.");
        Assert.Contains(state.Status.Describe(), Words(Draw(state, width, height)), StringComparison.Ordinal);
        Assert.Contains("Leave --order out", Words(Draw(state, width, height)), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(40, 12)]
    [InlineData(50, 20)]
    public void A_small_window_shows_who_is_there(int width, int height)
    {
        string text = string.Join('\n', Draw(WithPose(), width, height));
        foreach (string part in (string[])["RECEIVING", "studio:7001", "0 Char00", "0.0 Hz  lost 0", "front", "side", "q quit"])
            Assert.Contains(part, text, StringComparison.Ordinal);
    }

    [Fact]
    public void Feet_have_a_letter_on_the_ground_and_a_dot_above_it_with_and_without_colours()
    {
        // A foot stands that is where it was a frame before.
        LiveState state = WithPose();
        state.Take(Poses.Upright(index: 1));
        string none = string.Join('\n', Draw(state, 80, 24));
        string colours = string.Join('\n', Draw(state, 80, 24, isColoured: true));

        Assert.Matches("L R *\n", none);
        Assert.Contains("\e[", colours, StringComparison.Ordinal);
        Assert.Matches("L.*R", Escape().Replace(colours, string.Empty));

        // Half a metre above the ground no foot stands.
        state.Take(Poses.Upright(index: 2, height: 50));
        Assert.Matches("· · *\n", string.Join('\n', Draw(state, 80, 24)));
    }

    [Fact]
    public void A_small_window_shows_the_keys()
    {
        string text = string.Join('\n', Draw(WithPose(), 40, 12));
        Assert.EndsWith("q quit  ? help  r record  space freeze", text.TrimEnd(), StringComparison.Ordinal);
    }

    // Every word of every page, at every size.
    [Theory]
    [InlineData(40, 12)]
    [InlineData(50, 20)]
    [InlineData(80, 24)]
    [InlineData(132, 43)]
    public void The_help_is_never_cut(int width, int height)
    {
        LiveState state = WithHelp();
        int pages = Dashboard.CountHelpPages(state, width, height);
        string text = string.Empty;
        for (int page = 0; page < pages; page++)
        {
            state.HelpPage = page;
            string[] lines = Draw(state, width, height);
            Assert.DoesNotContain('…', string.Concat(lines));
            text += Words(lines);
        }

        foreach (string sentence in (string[])["start or stop a recording. It never replaces a file", "so the time in transit cannot be known", "and L and R below the feet that stand on it", "'diagnose' says how to get more"])
            Assert.Contains(sentence, text, StringComparison.Ordinal);
    }

    // The demo's or a server's sentence: an ellipsis would hide what the order comes from.
    [Theory]
    [InlineData(40, 12)]
    [InlineData(50, 20)]
    [InlineData(60, 16)]
    [InlineData(80, 24)]
    [InlineData(132, 43)]
    public void Nothing_is_cut_while_frames_arrive(int width, int height)
    {
        LiveState state = WithPose();
        state.Status = Receiving with { Message = "Receiving from 192.168.100.200:7001: binary format; rotation order YXZ assumed, the stream does not say." };
        state.Events.Add(DateTime.UnixEpoch, state.Status);
        string[] lines = Draw(state, width, height);
        Assert.DoesNotContain('…', string.Concat(lines));
        Assert.StartsWith(" RECEIVING ", lines[0], StringComparison.Ordinal);
        Assert.StartsWith("q quit", lines[^1], StringComparison.Ordinal);
        Assert.Equal(height > 12, Words(lines).Contains(state.Status.Describe(), StringComparison.Ordinal));
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

        // The last one comes into view when it is selected, in the drawing and in the table.
        state.SelectNextAvatar();
        state.SelectNextAvatar();
        string[] lines = Draw(state, width, height);
        Assert.Equal(2, lines.Count(static line => line.Contains("> 2 Actor2", StringComparison.Ordinal)));
        Assert.Equal(2, state.Selected?.Avatar);
    }

    [Fact]
    public void The_table_of_bones_gives_its_place_to_more_avatars()
    {
        LiveState state = WithThreePeople();
        state.BonePage = -1;
        string text = string.Join('\n', Draw(state, 80, 24));
        Assert.DoesNotContain("bones:", text, StringComparison.Ordinal);
        Assert.Contains("  2 Actor2 front", text, StringComparison.Ordinal);
    }

    [Fact]
    public void An_avatar_that_sends_no_more_says_so()
    {
        LiveState state = WithPose();
        state.TakenAt += 100 * Stopwatch.Frequency;
        Assert.Contains("no data for 1 min", string.Concat(Draw(state, 100, 30)), StringComparison.Ordinal);
    }

    [Fact]
    public void Feet_on_the_ground_have_a_letter_on_its_line()
    {
        LiveState state = WithPose();
        state.BonePage = -1;
        state.Take(Poses.Upright(index: 1));
        string ground = Draw(state, 40, 24).Last(static line => line.Contains('L', StringComparison.Ordinal));
        Assert.Matches("R.*L.*RL|R.*L.*LR|R.*L.*L", ground);

        state.Take(Poses.Upright(index: 2, height: 50));
        Assert.DoesNotContain(Draw(state, 40, 24), static line => line.Contains('⠤', StringComparison.Ordinal) && line.Contains('L', StringComparison.Ordinal));
    }

    [Fact]
    public void Without_a_keyboard_no_keys_are_offered()
    {
        var state = new LiveState(new WatchOptions()) { Status = Receiving, HasKeyboard = false };
        string last = Draw(state, 80, 24)[^1];
        Assert.StartsWith("Ctrl-C quits", last, StringComparison.Ordinal);
        Assert.DoesNotContain("record", last, StringComparison.Ordinal);
    }

    [Fact]
    public void What_a_key_did_is_said_at_the_top_and_stays_in_the_events()
    {
        LiveState state = WithPose();
        state.Say("Recorded 2.1 s, 121 frames, 179.1 kB to take.nmrec.");
        string[] lines = Draw(state, 80, 24);
        Assert.Equal("Recorded 2.1 s, 121 frames, 179.1 kB to take.nmrec.", lines[1].TrimEnd());
        Assert.Contains("● Recorded 2.1 s", lines[^2], StringComparison.Ordinal);
    }

    [Fact]
    public void What_only_colours_tell_apart_is_not_explained_without_them()
    {
        Assert.DoesNotContain("■ left", string.Concat(Draw(WithPose(), 80, 24)), StringComparison.Ordinal);
        Assert.Contains("■ left", Escape().Replace(string.Concat(Draw(WithPose(), 80, 24, isColoured: true)), string.Empty), StringComparison.Ordinal);
    }

    [Fact]
    public void The_timecode_and_the_buffer_are_shown()
    {
        var state = new LiveState(new WatchOptions { UdpPort = 7012 }) { Status = Receiving with { ReceiveBufferSize = 212_992 } };
        float[] values = new float[180];
        state.Take(new MotionFrame(new MotionHeader { Version = DataVersion.Studio, Reserved1 = 0x0A0B0C, Reserved2 = 7 }, values));
        string text = string.Join('\n', Draw(state, 80, 24));
        Assert.Contains("timecode 10:11:12:07", text, StringComparison.Ordinal);
        Assert.Contains("buffer 208 KiB", text, StringComparison.Ordinal);
    }

    private static LiveState State(ConnectionStatus status)
    {
        var state = new LiveState(new WatchOptions { Server = new ServerAddress("studio", 7001) }) { Status = status };
        state.Events.Add(DateTime.UnixEpoch, status);
        return state;
    }

    private static LiveState WithPose()
    {
        LiveState state = State(Receiving);
        state.Take(Poses.Upright());
        state.Counters.Take(default, [new AvatarStatistics { AvatarName = "Char00", Kind = PacketKind.Motion, LastTimestamp = state.Now }]);
        return state;
    }

    private static LiveState WithThreePeople()
    {
        LiveState state = State(Receiving);
        for (int avatar = 0; avatar < 3; avatar++)
            state.Take(Poses.Upright(x: 100 * avatar, avatar: avatar));

        state.Counters.Take(default, [.. Enumerable.Range(0, 3).Select(index => new AvatarStatistics
        {
            AvatarIndex = index, AvatarName = $"Actor{index}", Kind = PacketKind.Motion, LastTimestamp = state.Now,
        })]);
        return state;
    }

    private static LiveState WithManyAvatars()
    {
        LiveState state = WithPose();
        state.Counters.Take(default, [.. Enumerable.Range(0, 20).Select(index => new AvatarStatistics { AvatarIndex = index, AvatarName = $"演員 {index}" })]);
        return state;
    }

    private static LiveState WithHelp()
    {
        LiveState state = WithPose();
        state.HelpPage = 0;
        return state;
    }

    // The words in their order, without borders and line ends.
    private static string Words(string[] lines) => Spaces().Replace(string.Join(' ', lines.Select(static line => line.Trim('┃', ' '))), " ");

    private static string[] Draw(LiveState state, int width, int height, bool isColoured = false)
    {
        using var text = new StringWriter();
        IAnsiConsole console = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Ansi = isColoured ? AnsiSupport.Yes : AnsiSupport.No,
            ColorSystem = isColoured ? ColorSystemSupport.TrueColor : ColorSystemSupport.NoColors,
            Interactive = InteractionSupport.No,
            Out = new AnsiConsoleOutput(text),
        });
        console.Profile.Width = width;
        console.Profile.Height = height;
        console.Write(Dashboard.Create(state, width, height));
        return text.ToString().TrimEnd('\n').Split('\n');
    }

    [GeneratedRegex(" +", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Spaces();

    [GeneratedRegex("\\e\\[[0-9;]*m", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Escape();
}
