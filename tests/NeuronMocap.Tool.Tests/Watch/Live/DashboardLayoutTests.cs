using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Watch.Live;
using static NeuronMocap.Tool.Tests.Watch.Live.DashboardScreen;

namespace NeuronMocap.Tool.Tests.Watch.Live;

public sealed class DashboardLayoutTests
{
    public static TheoryData<int, int> Sizes => new() { { 1, 5 }, { 20, 5 }, { 40, 12 }, { 50, 15 }, { 60, 16 }, { 80, 24 }, { 99, 31 }, { 100, 32 }, { 120, 40 }, { 200, 50 }, { 400, 120 } };

    [Theory]
    [MemberData(nameof(Sizes))]
    public void Every_state_fits_every_window(int width, int height)
    {
        foreach (LiveState state in (LiveState[])[State(Refused), State(Receiving), WithPose(), WithManyAvatars(), WithHelp()])
        {
            string[] lines = Draw(state, width, height);
            Assert.InRange(lines.Length, 1, height);
            Assert.All(lines, line => Assert.True(line.Length <= width, line));
        }
    }

    // Also without room for the optional columns.
    [Theory]
    [InlineData(60, 16)]
    [InlineData(71, 20)]
    [InlineData(72, 20)]
    [InlineData(95, 24)]
    public void Every_allowed_width_shows_avatars_and_rates(int width, int height)
    {
        string text = string.Join('\n', Draw(WithPose(), width, height));
        foreach (string part in (string[])["avatar", "> 0 Char00", "84.1"])
            Assert.Contains(part, text, StringComparison.Ordinal);
    }

    // The longest sentences of the library. The setting to change is at their end.
    [Theory]
    [InlineData(40, 12)]
    [InlineData(50, 15)]
    [InlineData(60, 16)]
    [InlineData(80, 24)]
    [InlineData(200, 60)]
    public void An_explanation_is_never_cut(int width, int height)
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
    public void A_warning_about_frames_is_never_cut(int width, int height)
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
    public void A_small_window_shows_the_avatars(int width, int height)
    {
        string text = string.Join('\n', Draw(WithPose(), width, height));
        foreach (string part in (string[])["RECEIVING", "studio:7001", "0 Char00", "0.0 Hz  lost 0", "front", "side", "q quit"])
            Assert.Contains(part, text, StringComparison.Ordinal);
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

    // The sentence of the demo or a server. An ellipsis would hide the origin of the order.
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
}
