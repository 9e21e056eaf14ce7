using System.Globalization;
using System.Net;
using NeuronMocap.Protocol;
using NeuronMocap.Server;

namespace NeuronMocap.Simulator;

/// <summary>What the program says on standard output: what it sends, where, and on a terminal how it is going.</summary>
internal sealed class SimulatorReport(Broadcaster broadcaster, CommandServer? commands, BroadcasterOptions options, string description)
{
    private static readonly TimeSpan Interval = TimeSpan.FromSeconds(1);

    /// <summary>Reports until the broadcast is over.</summary>
    /// <exception cref="Exception">What a source threw.</exception>
    public void Run()
    {
        Console.WriteLine(Describe());

        // Scripts wait for these lines.
        if (broadcaster.LocalEndPoint is { } endPoint)
            Console.WriteLine($"Listening on {endPoint}");
        if (commands?.LocalEndPoint is { } commandPoint)
            Console.WriteLine($"Commands on {commandPoint}");
        foreach (IPEndPoint destination in options.UdpDestinations)
            Console.WriteLine($"Sending to {destination}");

        Console.Out.Flush();
        if (!Console.IsOutputRedirected)
            Watch();

        broadcaster.Completion.GetAwaiter().GetResult();
        Console.WriteLine(Summarize());
    }

    private void Watch()
    {
        while (Task.WaitAny([broadcaster.Completion], Interval) < 0)
            Console.Write($"\r{Summarize()}   ");

        Console.Write('\r');
    }

    private string Describe() => options.Recording is not null ? description : string.Create(
        CultureInfo.InvariantCulture,
        $"Broadcasting {description}: {Count(options.Sources.Count, "avatar")}, {Rate()}, {broadcaster.Layout.ValueCount} values, "
        + $"{options.RotationOrder}, {Format()}");

    private string Format()
    {
        bool hasCalculation = options.Calculation is not null || options.StudioCalculation is not null;
        return options.Format switch
        {
            BroadcastFormat.Text => $"text with {Count(options.TextDecimals, "decimal")}{(hasCalculation ? ", calculation lines" : "")}",
            BroadcastFormat.Studio => $"as Axis Studio, header {DataVersion.Studio}{(hasCalculation ? ", its calculation packets" : "")}",
            _ => $"header {options.DataVersion ?? DataVersion.New}{(hasCalculation ? ", calculation packets" : "")}",
        };
    }

    private string Rate() => double.IsPositiveInfinity(broadcaster.Rate)
        ? "as fast as clients read"
        : string.Create(CultureInfo.InvariantCulture, $"{broadcaster.Rate:0.###} Hz");

    private string Summarize()
    {
        BroadcasterStatistics statistics = broadcaster.Statistics;
        return string.Create(
            CultureInfo.InvariantCulture,
            $"{Count(statistics.Clients, "client")}, {Count(statistics.FramesSent, "frame")} sent, "
            + $"{Count(statistics.PacketsDropped, "packet")} dropped, {statistics.BytesSent / 1e6:0.0} MB{Commands(statistics)}");
    }

    // Only where somebody sent some: few will.
    private static string Commands(in BroadcasterStatistics statistics)
    {
        long unanswered = statistics.RequestsIgnored + statistics.RequestsDropped;
        return statistics.RepliesSent + unanswered == 0
            ? string.Empty
            : $", commands: {Count(statistics.RepliesSent, "reply", "replies")}, {unanswered.ToString(CultureInfo.InvariantCulture)} unanswered";
    }

    private static string Count(long number, string noun, string? plural = null) =>
        string.Create(CultureInfo.InvariantCulture, $"{number} {(number == 1 ? noun : plural ?? noun + "s")}");
}
