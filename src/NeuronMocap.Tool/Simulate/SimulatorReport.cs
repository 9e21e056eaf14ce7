using System.Globalization;
using System.Net;
using NeuronMocap.Server;

namespace NeuronMocap.Tool.Simulate;

/// <summary>What the program says on standard output: what it sends, where, and on a terminal how it is going.</summary>
internal sealed class SimulatorReport(Broadcaster broadcaster, CommandServer? commands, BroadcasterOptions options, string description)
{
    private static readonly TimeSpan Interval = TimeSpan.FromSeconds(1);

    /// <summary>Reports until the broadcast is over.</summary>
    /// <exception cref="SimulatorException">The file could not be read to its end.</exception>
    public void Run()
    {
        Console.WriteLine(Describe());

        // Scripts wait for these lines.
        if (broadcaster.LocalEndPoint is { } endPoint)
            Console.WriteLine($"Listening on {endPoint}");
        if (broadcaster.CalculationEndPoint is { } calculationPoint)
            Console.WriteLine($"Calculation on {calculationPoint}");
        if (commands?.LocalEndPoint is { } commandPoint)
            Console.WriteLine($"Commands on {commandPoint}");
        foreach (IPEndPoint destination in options.UdpDestinations)
        {
            Console.WriteLine($"Sending to {destination}");
            if (options.CalculationPort is int port)
                Console.WriteLine($"Calculation to {new IPEndPoint(destination.Address, port)}");
        }

        Console.Out.Flush();
        if (!Console.IsOutputRedirected)
            Watch();

        WaitForEnd();
        Console.WriteLine(Summarize(broadcaster.LocalEndPoint is null ? string.Empty : $"{Count(broadcaster.Statistics.Accepted, "client")} served in all, "));
    }

    private void WaitForEnd()
    {
        try
        {
            broadcaster.Completion.GetAwaiter().GetResult();
        }
        catch (Exception exception)
        {
            throw new SimulatorException($"the broadcast ended early: {exception.Message}");
        }
    }

    private void Watch()
    {
        while (Task.WaitAny([broadcaster.Completion], Interval) < 0)
            Console.Write($"\r{Summarize(broadcaster.LocalEndPoint is null ? string.Empty : $"{Clients()}, ")}   ");

        Console.Write('\r');
    }

    private string Describe() => options.Recording is not null ? description : string.Create(
        CultureInfo.InvariantCulture,
        $"Broadcasting {description}: {Count(options.Sources.Count, "avatar")}, {Rate()}, {broadcaster.Layout.ValueCount} values, "
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
        { Motion: false } => $", {packets} alone",
        { CalculationPort: not null } => $", {packets} on a port of their own",
        _ => $", {packets}",
    };

    private string Rate() => double.IsPositiveInfinity(broadcaster.Rate)
        ? "as fast as clients read"
        : string.Create(CultureInfo.InvariantCulture, $"{broadcaster.Rate:0.###} Hz");

    private string Clients()
    {
        BroadcasterStatistics statistics = broadcaster.Statistics;
        string ofCalculation = options.CalculationPort is null
            ? string.Empty
            : string.Create(CultureInfo.InvariantCulture, $" ({statistics.CalculationClients} of them for calculation)");
        return Count(statistics.Clients, "client") + ofCalculation;
    }

    private string Summarize(string clients)
    {
        BroadcasterStatistics statistics = broadcaster.Statistics;
        string calculation = statistics.CalculationFramesSent == 0 ? string.Empty : $" and {Count(statistics.CalculationFramesSent, "calculation frame")}";
        return string.Create(
            CultureInfo.InvariantCulture,
            $"{clients}{Count(statistics.FramesSent, "frame")}{calculation} sent, "
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
