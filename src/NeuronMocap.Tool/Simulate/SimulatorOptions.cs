using System.CommandLine;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Protocol;
using NeuronMocap.Server;
using NeuronMocap.Tool.Arguments;

namespace NeuronMocap.Tool.Simulate;

/// <summary>Converts the command line to the options of a broadcaster.</summary>
internal static class SimulatorOptions
{
    /// <summary>Creates the options for sources.</summary>
    /// <param name="arguments">The options.</param>
    /// <param name="result">A command line without errors.</param>
    /// <param name="sources">The sources.</param>
    /// <exception cref="UsageException">An option has no meaning here.</exception>
    /// <exception cref="SimulatorException">A host name has no address.</exception>
    public static BroadcasterOptions Create(SimulateArguments arguments, ParseResult result, SimulatorSources sources)
    {
        ServerAddress[] udp = result.GetValue(arguments.Udp) ?? [];
        BroadcastFormat format = result.GetValue(arguments.Format) ?? BroadcastFormat.Binary;
        int? calculationPort = GetCalculationPort(arguments, result, udp);
        bool motion = result.GetValue(arguments.Motion) != OnOff.Off;
        bool calculation = result.GetValue(arguments.Calculation) || calculationPort is not null || !motion;
        int? port = result.GetValue(arguments.Port) ?? (udp.Length > 0 ? null : ProtocolConstants.DefaultPort);
        CheckFormat(arguments, result, format);
        int? commands = result.GetResult(arguments.CommandPort) is null ? null : result.GetValue(arguments.CommandPort);
        CheckPorts(("--port", port), ("--calculation-port", port is null ? null : calculationPort), ("--command-port", commands));
        return new BroadcasterOptions
        {
            Sources = sources.Avatars,
            BindAddress = result.GetValue(arguments.Bind) ?? IPAddress.Loopback,
            Port = port,
            CalculationPort = calculationPort,
            SendMotion = motion,
            UdpDestinations = [.. udp.Select(Resolve)],
            FrameRate = result.GetValue(arguments.Rate),
            MaxFrames = result.GetValue(arguments.Frames),
            WaitForClient = result.GetValue(arguments.WaitForClient),
            IncludeDisplacement = result.GetValue(arguments.Displacement) is { } displacement ? displacement == OnOff.On : null,
            IncludeReference = result.GetValue(arguments.Reference) == OnOff.On,
            RotationOrder = result.GetValue(arguments.Order) ?? sources.Order ?? RotationOrder.YXZ,
            Format = format,
            DataVersion = result.GetValue(arguments.Header) == HeaderLayout.Old ? DataVersion.Old : null,
            TextDecimals = result.GetValue(arguments.Decimals) ?? TextEncoder.DefaultDecimals,
            Calculation = calculation && format != BroadcastFormat.Studio ? sources.WriteCalculation : null,
            CalculationValueCount = sources.CalculationValueCount,
            StudioCalculation = calculation && format == BroadcastFormat.Studio ? StudioCalculationSynthesizer.Write : null,
            AnswerDataCommands = result.GetValue(arguments.DataCommands) != OnOff.Off,
            Fragment = result.GetValue(arguments.Fragment),
        };
    }

    /// <summary>Creates the options for a recording.</summary>
    /// <param name="arguments">The options.</param>
    /// <param name="result">A command line without errors.</param>
    /// <param name="play">The recording.</param>
    /// <exception cref="UsageException">An option has no meaning here.</exception>
    /// <exception cref="SimulatorException">A host name has no address.</exception>
    public static BroadcasterOptions Create(SimulateArguments arguments, ParseResult result, SimulatedPlaySettings play)
    {
        ServerAddress[] udp = result.GetValue(arguments.Udp) ?? [];
        int? port = result.GetValue(arguments.Port) ?? (udp.Length > 0 ? null : ProtocolConstants.DefaultPort);
        int? calculationPort = GetCalculationPort(arguments, result, udp);
        CheckPorts(("--port", port), ("--calculation-port", port is null ? null : calculationPort));
        return new BroadcasterOptions
        {
            CalculationPort = calculationPort,
            RecordingPath = play.Path,
            RecordingSpeed = play.Speed,
            LoopRecording = play.Loop,
            FrameRate = result.GetValue(arguments.Rate),
            BindAddress = result.GetValue(arguments.Bind) ?? IPAddress.Loopback,
            Port = port,
            UdpDestinations = [.. udp.Select(Resolve)],
            WaitForClient = result.GetValue(arguments.WaitForClient),
            Fragment = result.GetValue(arguments.Fragment),
        };
    }

    private static int? GetCalculationPort(SimulateArguments arguments, ParseResult result, ServerAddress[] udp)
    {
        int? port = result.GetResult(arguments.CalculationPort) is null ? null : result.GetValue(arguments.CalculationPort);
        return udp.Length > 0 && port == 0
            ? throw new UsageException("--calculation-port 0 takes a free port to listen on; with --udp it is a port to send to, from 1 to 65535.")
            : port;
    }

    private static void CheckFormat(SimulateArguments arguments, ParseResult result, BroadcastFormat format)
    {
        HeaderLayout? header = result.GetValue(arguments.Header);
        if (format == BroadcastFormat.Text && header is not null)
            throw new UsageException("--format text has no headers: leave out --header.");
        if (format == BroadcastFormat.Studio && header == HeaderLayout.Old)
            throw new UsageException("--format studio uses the new header; for Axis Studio's old header use --format binary --header old.");
        if (format != BroadcastFormat.Text && result.GetValue(arguments.Decimals) is not null)
            throw new UsageException("--decimals is for --format text; packets carry every value as it is.");
    }

    private static void CheckPorts(params (string Option, int? Port)[] ports)
    {
        foreach (IGrouping<int?, string> same in ports.Where(port => port.Port > 0).GroupBy(port => port.Port, port => port.Option))
        {
            if (same.Count() > 1)
                throw new UsageException($"{string.Join(" and ", same)} are both {same.Key}; each needs its own port.");
        }
    }

    private static IPEndPoint Resolve(ServerAddress destination)
    {
        (string host, int port) = destination;
        if (IPAddress.TryParse(host, out IPAddress? address))
            return new IPEndPoint(address, port);

        try
        {
            // IPv4 first, because the vendor's readers bind only to IPv4 (protocol.md section 4.2).
            IPAddress[] addresses = Dns.GetHostAddresses(host);
            return new IPEndPoint(addresses.OrderBy(candidate => candidate.AddressFamily != AddressFamily.InterNetwork).First(), port);
        }
        catch (SocketException exception)
        {
            throw new SimulatorException($"--udp: the host name {host} has no address ({exception.SocketErrorCode}).");
        }
    }
}
