using System.Text.RegularExpressions;
using NeuronMocap.Tool.Arguments;
using NeuronMocap.Tool.Tests.Infrastructure;
using NeuronMocap.Tool.Watch.Live;
using Spectre.Console;

namespace NeuronMocap.Tool.Tests.Watch.Live;

/// <summary>States of the live view, and their look.</summary>
internal static partial class DashboardScreen
{
    public static readonly ConnectionStatus Receiving = new(ConnectionState.Receiving, ConnectionReason.None, "Receiving from studio:7001.");

    public static readonly ConnectionStatus Refused = new(ConnectionState.Waiting, ConnectionReason.Refused, "Nothing listens there. Check the port.")
    {
        Attempt = 2,
        RetryIn = TimeSpan.FromSeconds(3),
    };

    public static LiveState State(ConnectionStatus status)
    {
        var state = new LiveState(new ConnectionOptions { Server = new ServerAddress("studio", 7001) }) { Status = status };
        state.Events.Add(DateTime.UnixEpoch, status);
        return state;
    }

    public static LiveState WithPose()
    {
        LiveState state = State(Receiving);
        state.Take(Poses.Upright());
        state.Counters.Take(default, [new AvatarStatistics { AvatarName = "Char00", Kind = PacketKind.Motion, LastTimestamp = state.Now }]);
        return state;
    }

    public static LiveState WithThreePeople()
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

    public static LiveState WithManyAvatars()
    {
        LiveState state = WithPose();
        state.Counters.Take(default, [.. Enumerable.Range(0, 20).Select(index => new AvatarStatistics { AvatarIndex = index, AvatarName = $"演員 {index}" })]);
        return state;
    }

    public static LiveState WithHelp()
    {
        LiveState state = WithPose();
        state.HelpPage = 0;
        return state;
    }

    public static string[] Draw(LiveState state, int width, int height, bool isColoured = false)
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

    // The words in order, without borders and line ends.
    public static string Words(string[] lines) => Spaces().Replace(string.Join(' ', lines.Select(static line => line.Trim('┃', ' '))), " ");

    public static string WithoutColours(string text) => Escape().Replace(text, string.Empty);

    [GeneratedRegex(" +", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Spaces();

    [GeneratedRegex("\\e\\[[0-9;]*m", RegexOptions.ExplicitCapture, matchTimeoutMilliseconds: 1000)]
    private static partial Regex Escape();
}
