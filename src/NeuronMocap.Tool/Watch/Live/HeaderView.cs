using System.Diagnostics;
using NeuronMocap.Recording;
using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Play;
using NeuronMocap.Tool.Terminal;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>Where from, in which state and since when, why, and what kind of stream.</summary>
internal static class HeaderView
{
    // Besides the reason, which has one line, and more where a file failed, or the skeleton is shown and something is wrong all the same.
    private const int OtherLines = 2;
    private const int MostReasonLines = 3;

    /// <summary>Lines that it takes.</summary>
    public static int HeightOf(LiveState state, int width) => OtherLines + Reason(state, width).Count;

    public static IRenderable Create(LiveState state, int width) => new Rows([Connection(state), .. Reason(state, width), Stream(state)]);

    /// <summary>"next attempt in 2.1 s", or nothing.</summary>
    public static string DescribeRetry(ConnectionStatus status, long now)
    {
        if (status.RetryIn is not { } delay)
            return string.Empty;

        TimeSpan left = delay - Stopwatch.GetElapsedTime(status.Timestamp, now);
        return Quantity.Format($"attempt {status.Attempt} failed, next in {Math.Max(left.TotalSeconds, 0):0.0} s");
    }

    private static StyledLine Connection(LiveState state)
    {
        ConnectionStatus status = state.Status;
        TimeSpan since = Stopwatch.GetElapsedTime(status.Timestamp, state.Now);
        string time = (DateTime.Now - since).ToString("HH:mm:ss", provider: null);
        var line = new StyledLine()
            .Add($" {status.State.ToString().ToUpperInvariant()} ", new Style(Color.Black, Palette.Of(status.State), Decoration.Bold))
            .Add(" ")
            .Add(DescribeSource(state), Palette.StrongStyle)
            .Add($"  since {time} ({Quantity.Duration(since)})", Palette.DimStyle);
        if (state.IsPaused)
            line.AddRight(" PAUSED ", new Style(Color.Black, Palette.Warning, Decoration.Bold)).AddRight(" ");

        AddRecording(line, state.Recorder);
        return line.AddRight($"up {state.Uptime:hh\\:mm\\:ss}", Palette.DimStyle);
    }

    // " REC 12.3 MB ", and what is missing; red when it is over.
    private static void AddRecording(StyledLine line, StreamRecorder? recorder)
    {
        if (recorder is null)
            return;

        RecordingStatistics statistics = recorder.GetStatistics();
        if (recorder.Failure is not null)
            line.AddRight(" RECORDING FAILED ", new Style(Color.Black, Palette.Bad, Decoration.Bold));
        else
            line.AddRight($"● REC {Quantity.Bytes(statistics.Bytes)}", new Style(Palette.Bad, decoration: Decoration.Bold));
        if (statistics.LostBytes > 0)
            line.AddRight($" {Quantity.Bytes(statistics.LostBytes)} lost", new Style(Palette.Warning));

        line.AddRight("  ");
    }

    /// <summary>What is received from, in a few words.</summary>
    public static string DescribeSource(LiveState state)
    {
        if (state.Player is { } player)
            return $"{TerminalText.Clean(player.FileName)}  {PlaybackKeys.Describe(player)}";
        if (state.Options.UdpPort is { } port)
            return state.Status.ReceiveBufferSize is { } buffer ? $"UDP port {port}, buffer {Quantity.Memory(buffer)}" : $"UDP port {port}";

        return state.Options.Server is { } server ? $"TCP {server}" : $"TCP {state.Status.RemoteEndPoint?.ToString() ?? "loopback"} (demo)";
    }

    // A file that is not written any more must not be found out at the end.
    private static IReadOnlyList<StyledLine> Reason(LiveState state, int width) =>
    [
        .. state.FileFailures.SelectMany(failure => Wrap(failure.Text, width, new Style(Palette.Bad, decoration: Decoration.Bold))),
        .. StatusLines(state, width),
    ];

    private static IReadOnlyList<StyledLine> StatusLines(LiveState state, int width)
    {
        ConnectionStatus status = state.Status;
        if (status.State != ConnectionState.Receiving)
        {
            return
            [
                new StyledLine().Add(status.Describe(), new Style(Palette.Of(status.State)))
                    .AddRight(DescribeRetry(status, state.Now), new Style(Palette.Warning)),
            ];
        }

        if (status.Reason == ConnectionReason.None)
            return [new StyledLine().Add(status.Describe(), Palette.DimStyle)];

        return Wrap(status.Describe(), width, new Style(Palette.Warning));
    }

    private static IReadOnlyList<StyledLine> Wrap(string text, int width, Style style) =>
        [.. WrappedText.Break(text, width, MostReasonLines).Select(line => new StyledLine().Add(line, style))];

    private static StyledLine Stream(LiveState state)
    {
        if (state.Pose is not { } pose)
            return new StyledLine().Add("stream: no motion frame yet", Palette.DimStyle);

        MotionHeader header = pose.Header;
        string version = header.Version == DataVersion.None ? "text" : $"{header.Version} {(header.Layout == HeaderLayout.New ? "NEW" : "OLD")}";
        StyledLine line = new StyledLine()
            .Add("stream ", Palette.DimStyle)
            .Add(version)
            .Add(" · ", Palette.DimStyle)
            .Add($"{header.ValueCount} values")
            .Add($" · displacement {OnOff(header.HasDisplacement)} · reference {OnOff(header.HasReference)}", Palette.DimStyle)
            .Add($" · {DescribeOrder(state, pose)}", Palette.DimStyle);
        return header.Timecode is { } timecode ? line.AddRight($"timecode {timecode}") : line;
    }

    // Axis Studio's stream says its order; a wrong guess is what makes a body fold up. Where others may say it, the status tells whether they did.
    private static string DescribeOrder(LiveState state, Pose pose)
    {
        RotationOrder order = pose.Format.RotationOrder;
        if (state.Options.RotationOrder is not null)
            return $"{order} by --order";
        if (pose.Header.Version == DataVersion.Studio)
            return $"{order} as the stream says";

        bool mayBeTold = state.Options.CommandPort is not null || state.Options.Play is not null;
        return mayBeTold ? $"rotation order {order}" : $"{order} assumed";
    }

    private static string OnOff(bool on) => on ? "on" : "off";
}
