using System.Diagnostics;
using NeuronMocap.Monitor.Playback;
using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Transport;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace NeuronMocap.Monitor.Terminal;

/// <summary>Where from, in which state and since when, and what kind of stream: three lines.</summary>
internal static class HeaderView
{
    public const int Height = 3;

    public static IRenderable Create(LiveState state) => new Rows(Connection(state), Reason(state.Status, state.Now), Stream(state));

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

    private static string DescribeSource(LiveState state)
    {
        if (state.Player is { } player)
            return $"{TerminalText.Clean(player.FileName)}  {PlaybackKeys.Describe(player)}";
        if (state.Options.UdpPort is { } port)
            return $"UDP port {port}";

        return state.Options.Server is { } server ? $"TCP {server}" : $"TCP {state.Status.RemoteEndPoint?.ToString() ?? "loopback"} (demo)";
    }

    private static StyledLine Reason(ConnectionStatus status, long now)
    {
        Style style = status.State == ConnectionState.Receiving ? Palette.DimStyle : new Style(Palette.Of(status.State));
        return new StyledLine().Add(status.Message, style).AddRight(DescribeRetry(status, now), new Style(Palette.Warning));
    }

    private static StyledLine Stream(LiveState state)
    {
        if (state.Pose is not { } pose)
            return new StyledLine().Add("stream: no motion frame yet", Palette.DimStyle);

        MotionHeader header = pose.Header;
        string version = header.Version == DataVersion.None ? "text" : $"{header.Version} {(header.Layout == HeaderLayout.New ? "NEW" : "OLD")}";
        return new StyledLine()
            .Add("stream ", Palette.DimStyle)
            .Add(version)
            .Add(" · ", Palette.DimStyle)
            .Add($"{header.ValueCount} values")
            .Add($" · displacement {OnOff(header.HasDisplacement)} · reference {OnOff(header.HasReference)}", Palette.DimStyle)
            .Add($" · {DescribeOrder(state.Options.RotationOrder is not null, pose)}", Palette.DimStyle);
    }

    // Axis Studio's stream says its order; a wrong guess is what makes a body fold up.
    private static string DescribeOrder(bool isOption, Pose pose) => isOption ? $"{pose.Format.RotationOrder} by --order"
        : pose.Header.Version == DataVersion.Studio ? $"{pose.Format.RotationOrder} as the stream says"
        : $"{pose.Format.RotationOrder} assumed";

    private static string OnOff(bool on) => on ? "on" : "off";
}
