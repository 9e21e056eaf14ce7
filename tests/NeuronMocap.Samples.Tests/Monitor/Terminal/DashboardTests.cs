using NeuronMocap.Delivery;
using NeuronMocap.Monitor;
using NeuronMocap.Monitor.Terminal;
using NeuronMocap.Protocol;
using NeuronMocap.Samples.Tests.Infrastructure;
using NeuronMocap.Transport;
using Spectre.Console;

namespace NeuronMocap.Samples.Tests.Monitor.Terminal;

public sealed class DashboardTests
{
    private static readonly ConnectionStatus Receiving = new(ConnectionState.Receiving, ConnectionReason.None, "Receiving from studio:7001.");

    private static readonly ConnectionStatus Refused = new(ConnectionState.Waiting, ConnectionReason.Refused, "Nothing listens there. Check the port.")
    {
        Attempt = 2,
        RetryIn = TimeSpan.FromSeconds(3),
    };

    public static TheoryData<int, int> Sizes => new() { { 1, 5 }, { 20, 5 }, { 60, 16 }, { 80, 24 }, { 99, 31 }, { 100, 32 }, { 120, 40 }, { 200, 50 }, { 400, 120 } };

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
            AvatarName = "Char00", Rate = 30, FrequencyReduction = 2, Gaps = 41, Restarts = 43, LastTimestamp = state.Now,
        }]);

        Assert.Contains("30.0/2", string.Concat(Draw(state, 80, 24)), StringComparison.Ordinal);
        string wide = string.Concat(Draw(state, 140, 40));
        foreach (string part in (string[])["30.0/2", "gaps", "41", "restarts", "43"])
            Assert.Contains(part, wide, StringComparison.Ordinal);
    }

    [Fact]
    public void A_name_from_the_network_cannot_command_the_terminal()
    {
        LiveState state = State(Receiving);
        state.Counters.Take(default, [new AvatarStatistics { AvatarName = "\e[2J", LastTimestamp = state.Now }]);
        Assert.DoesNotContain('\e', string.Concat(Draw(state, 80, 24)));
    }

    private static LiveState State(ConnectionStatus status)
    {
        var state = new LiveState(new MonitorOptions { Server = new ServerAddress("studio", 7001) }) { Status = status };
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

    private static LiveState WithManyAvatars()
    {
        LiveState state = WithPose();
        state.Counters.Take(default, [.. Enumerable.Range(0, 20).Select(index => new AvatarStatistics { AvatarIndex = index, AvatarName = $"演員 {index}" })]);
        return state;
    }

    private static LiveState WithHelp()
    {
        LiveState state = WithPose();
        state.ShowsHelp = true;
        return state;
    }

    private static string[] Draw(LiveState state, int width, int height)
    {
        using var text = new StringWriter();
        IAnsiConsole console = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Ansi = AnsiSupport.No,
            Interactive = InteractionSupport.No,
            Out = new AnsiConsoleOutput(text),
        });
        console.Profile.Width = width;
        console.Profile.Height = height;
        console.Write(Dashboard.Create(state, width, height));
        return text.ToString().TrimEnd('\n').Split('\n');
    }
}
