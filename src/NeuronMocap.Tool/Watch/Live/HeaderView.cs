using System.Diagnostics;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Terminal;
using NeuronMocap.Tool.Watch.Playback;
using Spectre.Console;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>The lines at the top, the most important first: state, source, recording, problems, and the kind of stream.</summary>
internal static class HeaderView
{
    private const string Gap = "  ";

    private static readonly Style RecordingStyle = new(Palette.Bad, decoration: Decoration.Bold);

    /// <summary>Creates the lines that every window shows: state, source, recording and failed files.</summary>
    public static IReadOnlyList<StyledLine> Essentials(LiveState state, int width)
    {
        ConnectionStatus status = state.Status;
        TimeSpan since = Stopwatch.GetElapsedTime(status.Timestamp, state.Now);
        string time = (DateTime.Now - since).ToString("HH:mm:ss", provider: null);
        IReadOnlyList<StyledLine> lines = Piece.Flow(
            [.. Connection(state), .. Recording(state)],
            [new Piece($"since {time} ({Quantity.Duration(since)})", Palette.DimStyle), new Piece($"up {state.Uptime:hh\\:mm\\:ss}", Palette.DimStyle)],
            Gap,
            width);
        return [.. lines, .. Alarms(state, width)];
    }

    /// <summary>Creates the text of the status while frames arrive without problems.</summary>
    public static IReadOnlyList<StyledLine> Sentence(LiveState state, int width) =>
        state.Status is { State: ConnectionState.Receiving, Reason: ConnectionReason.None } ? Wrap(state.Status.Describe(), width, Palette.DimStyle) : [];

    /// <summary>Creates the description of the stream.</summary>
    public static IReadOnlyList<StyledLine> Stream(LiveState state, int width)
    {
        if (state.Pose is not { } pose)
            return [];

        MotionHeader header = pose.Header;
        string version = header.Version == DataVersion.None ? "text" : $"{header.Version} {(header.Layout == HeaderLayout.New ? "NEW" : "OLD")}";
        List<Piece> pieces =
        [
            new Piece("stream ", Palette.DimStyle).Add(version),
            new Piece($"{header.ValueCount} {Quantity.Noun(header.ValueCount, "value")}"),
            new Piece($"displacement {OnOff(header.HasDisplacement)}", Palette.DimStyle),
            new Piece($"reference {OnOff(header.HasReference)}", Palette.DimStyle),
            new Piece(DescribeOrder(state, pose), Palette.DimStyle),
        ];
        if (header.Timecode is { } timecode)
            pieces.Add(new Piece($"timecode {timecode}"));

        return Piece.Flow(pieces, " · ", width);
    }

    /// <summary>Formats "attempt 2 failed, next in 2.1 s", or an empty text.</summary>
    public static string DescribeRetry(ConnectionStatus status, long now)
    {
        if (status.RetryIn is not { } delay)
            return string.Empty;

        TimeSpan left = delay - Stopwatch.GetElapsedTime(status.Timestamp, now);
        return Quantity.Format($"attempt {status.Attempt} failed, next in {Math.Max(left.TotalSeconds, 0):0.0} s");
    }

    private static IEnumerable<Piece> Connection(LiveState state)
    {
        yield return Badge(state.Status.State.ToString().ToUpperInvariant(), Palette.Of(state.Status.State));
        foreach (string words in DescribeSource(state))
            yield return new Piece(words, Palette.StrongStyle);

        if (state.IsPaused)
            yield return Badge("PAUSED", Palette.Warning);
    }

    private static IEnumerable<string> DescribeSource(LiveState state)
    {
        if (state.Player is { } player)
            return [player.FileName, PlaybackKeys.Describe(player)];
        if (state.Connection.UdpPort is { } port)
            return state.Status is { ReceiveBufferSize: { } granted, RequestedReceiveBufferSize: { } requested }
                ? [$"UDP port {port}", $"receive buffer {Quantity.Memory(granted)} of {Quantity.Memory(requested)}"]
                : [$"UDP port {port}"];
        if (state.Connection.VmcPort is { } poses)
            return state.Connection.LocalAddress is { } own ? [$"VMC port {poses} of {own}"] : [$"VMC port {poses}"];

        if (state.Connection.Broker is { } broker)
            return [broker.ToString()];
        if (state.Connection.WebSocket is not null)
            return [state.Connection.Source];

        return [state.Connection.Server is { } server ? $"{(state.Connection.Tls is null ? "TCP" : "TLS")} {server}" : $"TCP {state.Status.RemoteEndPoint?.ToString() ?? "loopback"} (demo)"];
    }

    private static IEnumerable<Piece> Recording(LiveState state)
    {
        if (state.Takes is not { Current: { } take } takes)
            yield break;

        RecordingStatistics statistics = take.Recorder.GetStatistics();
        yield return new Piece(
            Quantity.Format($"● REC {Quantity.Duration(statistics.Duration)}, {Quantity.Count(take.CountFrames(takes.FramesArrived), "frame")}, {Quantity.Bytes(statistics.Bytes)}"),
            RecordingStyle);
        yield return new Piece($"to {take.Recorder.CurrentPath}", Palette.DimStyle);
        if (statistics.LostBytes > 0)
            yield return new Piece($"{Quantity.Bytes(statistics.LostBytes)} lost: the disk is too slow", Palette.WarningStyle);
    }

    // A failed file must not come as a surprise at the end.
    private static IEnumerable<StyledLine> Alarms(LiveState state, int width)
    {
        foreach (FileFailure failure in state.FileFailures)
        {
            foreach (StyledLine line in Wrap(failure.Alarm, width, RecordingStyle))
                yield return line;
        }

        foreach (StyledLine line in state.Notice is { } notice ? Wrap(notice, width, Palette.StrongStyle) : [])
            yield return line;

        bool isDoubtful = state.Status is { State: ConnectionState.Receiving, Reason: not ConnectionReason.None };
        foreach (StyledLine line in isDoubtful ? Wrap(state.Status.Describe(), width, Palette.WarningStyle) : [])
            yield return line;
    }

    private static Piece Badge(string text, Color color) => new($" {text} ", new Style(Color.Black, color, Decoration.Bold));

    private static IReadOnlyList<StyledLine> Wrap(string text, int width, Style style) =>
        [.. WrappedText.Break(TerminalText.Clean(text), width, int.MaxValue).Select(line => new StyledLine().Add(line, style))];

    // Axis Studio's stream carries its order. A wrong guess makes the body fold up. If a command channel is set, the status says whether it gave the
    // order.
    private static string DescribeOrder(LiveState state, Pose pose)
    {
        RotationOrder order = pose.Format.RotationOrder;
        if (state.Connection.RotationOrder is not null)
            return $"{order} by --order";
        if (pose.Header.Version == DataVersion.Studio)
            return $"{order} as the stream says";

        bool isOrderAvailable = state.Connection.CommandPort is not null || state.Player is not null;
        return isOrderAvailable ? $"rotation order {order}" : $"{order} assumed";
    }

    private static string OnOff(bool on) => on ? "on" : "off";
}
