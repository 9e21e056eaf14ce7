using System.Globalization;
using System.Net;
using NeuronMocap.Server;
using NeuronMocap.Tool.Files;
using NeuronMocap.Tool.Terminal;
using Spectre.Console;

namespace NeuronMocap.Tool.Simulate;

/// <summary>The standard output of simulate: what it sends and where, on a terminal its progress, and at the end a summary.</summary>
internal sealed class SimulatorReport(
    Broadcaster broadcaster, CommandServer? commands, BroadcasterOptions options, string description, StandardStreams streams)
{
    private const int WidestText = 160;

    private static readonly TimeSpan Interval = TimeSpan.FromSeconds(1);

    private readonly TextPage _page = new(streams, WidestText);
    private bool _isOutputClosed;

    /// <summary>Reports until the broadcast is over.</summary>
    /// <exception cref="SimulatorException">The file could not be read to its end, or the output could not be written.</exception>
    public async Task RunAsync()
    {
        WriteLine(Describe());

        // Scripts wait for these lines.
        if (broadcaster.LocalEndPoint is { } endPoint)
            WriteLine($"Listening on {endPoint}");
        if (broadcaster.CalculationEndPoint is { } calculationPoint)
            WriteLine($"Calculation on {calculationPoint}");
        if (commands?.LocalEndPoint is { } commandPoint)
            WriteLine($"Commands on {commandPoint}");
        foreach (IPEndPoint destination in options.UdpDestinations)
        {
            WriteLine($"Sending to {destination}");
            if (options.CalculationPort is int port)
                WriteLine($"Calculation to {new IPEndPoint(destination.Address, port)}");
        }

        if (streams.IsTerminal)
            WriteLine("Ctrl+C ends the program.");
        if (streams.IsTerminal && Screen.IsSupported)
            await WatchAsync();

        await WaitForEndAsync();
        WriteLine(Summarize(broadcaster.LocalEndPoint is null ? string.Empty : $"Served {Count(broadcaster.GetStatistics().Accepted, "client")}: "));
    }

    private async Task WaitForEndAsync()
    {
        try
        {
            await broadcaster.Completion;
        }
        catch (Exception exception)
        {
            throw new SimulatorException($"the broadcast ended early: {exception.Message}");
        }
    }

    // Redrawn every second and removed at the end.
    private Task WatchAsync() => _page.Console.Live(Progress()).AutoClear(enabled: true).StartAsync(async view =>
    {
        while (await Task.WhenAny(broadcaster.Completion, Task.Delay(Interval)) != broadcaster.Completion)
            view.UpdateTarget(Progress());
    });

    // Two lines: for a single line the library moves the cursor up by 0 lines, which terminals treat as 1.
    private Padder Progress() =>
        new(new Text(Summarize(broadcaster.LocalEndPoint is null ? string.Empty : $"{Clients()}, "), Palette.DimStyle), new Padding(0, 1, 0, 0));

    // The program that reads the output may close it after it has read the addresses.
    private void WriteLine(string line)
    {
        if (_isOutputClosed)
            return;

        try
        {
            _page.WriteLine(line);
        }
        catch (IOException exception) when (StandardStreams.IsBrokenPipe(exception))
        {
            _isOutputClosed = true;
        }
        catch (IOException exception)
        {
            throw new SimulatorException(FileFault.OfStandardOutput(exception));
        }
    }

    private string Describe() => options.RecordingPath is not null ? description : string.Create(
        CultureInfo.InvariantCulture,
        $"Broadcasting {description}: {Count(options.Sources.Count, "avatar")}, {DescribeFrameRate()}, {Count(broadcaster.Layout.ValueCount, "value")}, "
        + $"{options.RotationOrder}, {Format()}");

    private string Format() => options.Format switch
    {
        BroadcastFormat.Text => $"text with {Count(options.TextDecimals, "decimal")}{Calculation("calculation lines")}",
        BroadcastFormat.Studio => $"as Axis Studio, header {DataVersion.Studio}{Calculation("its calculation packets")}",
        _ => $"header {options.DataVersion ?? DataVersion.New}{Calculation("calculation packets")}",
    };

    private string Calculation(string packets) => options switch
    {
        { Calculation: null, StudioCalculation: null } => string.Empty,
        { SendMotion: false } => $", {packets} alone",
        { CalculationPort: not null } => $", {packets} on a separate port",
        _ => $", {packets}",
    };

    private string DescribeFrameRate() => double.IsPositiveInfinity(broadcaster.FrameRate)
        ? "as fast as clients read"
        : string.Create(CultureInfo.InvariantCulture, $"{broadcaster.FrameRate:0.###} Hz");

    private string Clients()
    {
        BroadcasterStatistics statistics = broadcaster.GetStatistics();
        string ofCalculation = options.CalculationPort is null
            ? string.Empty
            : string.Create(CultureInfo.InvariantCulture, $" ({statistics.CalculationClients} of them for calculation)");
        return Count(statistics.Clients, "client") + ofCalculation;
    }

    private string Summarize(string clients)
    {
        BroadcasterStatistics statistics = broadcaster.GetStatistics();
        string calculation = statistics.CalculationFramesSent == 0 ? string.Empty : $" and {Count(statistics.CalculationFramesSent, "calculation frame")}";
        return string.Create(
            CultureInfo.InvariantCulture,
            $"{clients}{Count(statistics.FramesSent, "frame")}{calculation} sent, "
            + $"{Count(statistics.PacketsDropped, "packet")} dropped, {statistics.BytesSent / 1e6:0.0} MB{Commands(statistics)}");
    }

    // Only if clients sent commands, which is rare.
    private static string Commands(in BroadcasterStatistics statistics)
    {
        long unanswered = statistics.RequestsIgnored + statistics.RequestsDropped;
        return statistics.RepliesSent + unanswered == 0
            ? string.Empty
            : $", commands: {Count(statistics.RepliesSent, "reply", "replies")}, {unanswered.ToString(CultureInfo.InvariantCulture)} unanswered";
    }

    private static string Count(long number, string noun, string? plural = null) =>
        string.Create(CultureInfo.InvariantCulture, $"{number} {Quantity.Noun(number, noun, plural)}");
}
