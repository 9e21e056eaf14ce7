using System.CommandLine;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Protocol;
using NeuronMocap.Server;

namespace NeuronMocap.Tool.Simulate;

/// <summary>Turns the command line into the options of a broadcaster.</summary>
internal static class SimulatorOptions
{
    /// <summary>Makes the options.</summary>
    /// <param name="command">The options of the program.</param>
    /// <param name="result">A command line without errors.</param>
    /// <param name="sources">What to play.</param>
    /// <exception cref="UsageException">An option has no meaning here.</exception>
    /// <exception cref="SimulatorException">A host name leads nowhere.</exception>
    public static BroadcasterOptions Create(SimulatorCommand command, ParseResult result, SimulatorSources sources)
    {
        string[] udp = result.GetValue(command.Udp) ?? [];
        BroadcastFormat format = result.GetValue(command.Format) ?? BroadcastFormat.Binary;
        int? calculationPort = GetCalculationPort(command, result, udp);
        bool motion = result.GetValue(command.Motion) != OnOff.Off;
        bool calculation = result.GetValue(command.Calculation) || calculationPort is not null || !motion;
        int? port = result.GetValue(command.Port) ?? (udp.Length > 0 ? null : ProtocolConstants.DefaultPort);
        CheckFormat(command, result, format);
        int? commands = result.GetResult(command.Commands) is null ? null : result.GetValue(command.Commands);
        CheckPorts(("--port", port), ("--calculation-port", port is null ? null : calculationPort), ("--commands", commands));
        return new BroadcasterOptions
        {
            Sources = sources.Avatars,
            BindAddress = result.GetValue(command.Bind) ?? IPAddress.Loopback,
            Port = port,
            CalculationPort = calculationPort,
            Motion = motion,
            UdpDestinations = [.. udp.Select(Resolve)],
            Rate = result.GetValue(command.Rate),
            FrameLimit = result.GetValue(command.Frames),
            WaitForClient = result.GetValue(command.WaitForClient),
            Displacement = result.GetValue(command.Displacement) is { } displacement ? displacement == OnOff.On : null,
            Reference = result.GetValue(command.Reference) == OnOff.On,
            RotationOrder = result.GetValue(command.Order) ?? sources.Order ?? RotationOrder.YXZ,
            Format = format,
            DataVersion = result.GetValue(command.Header) == HeaderLayout.Old ? DataVersion.Old : null,
            TextDecimals = result.GetValue(command.Decimals) ?? TextEncoder.DefaultDecimals,
            Calculation = calculation && format != BroadcastFormat.Studio ? sources.WriteCalculation : null,
            CalculationValueCount = sources.CalculationValueCount,
            StudioCalculation = calculation && format == BroadcastFormat.Studio ? StudioCalculationSynthesizer.Write : null,
            AnswerDataCommands = result.GetValue(command.DataCommands) != OnOff.Off,
            Fragment = result.GetValue(command.Fragment),
        };
    }

    /// <summary>Makes the options of a recording.</summary>
    /// <param name="command">The options of the program.</param>
    /// <param name="result">A command line without errors.</param>
    /// <param name="play">What to play.</param>
    /// <exception cref="UsageException">An option has no meaning here.</exception>
    /// <exception cref="SimulatorException">A host name leads nowhere.</exception>
    public static BroadcasterOptions Create(SimulatorCommand command, ParseResult result, SimulatedPlaySettings play)
    {
        string[] udp = result.GetValue(command.Udp) ?? [];
        int? port = result.GetValue(command.Port) ?? (udp.Length > 0 ? null : ProtocolConstants.DefaultPort);
        int? calculationPort = GetCalculationPort(command, result, udp);
        CheckPorts(("--port", port), ("--calculation-port", port is null ? null : calculationPort));
        return new BroadcasterOptions
        {
            CalculationPort = calculationPort,
            Recording = play.Path,
            RecordingSpeed = play.Speed,
            LoopRecording = play.Loop,
            Rate = result.GetValue(command.Rate),
            BindAddress = result.GetValue(command.Bind) ?? IPAddress.Loopback,
            Port = port,
            UdpDestinations = [.. udp.Select(Resolve)],
            WaitForClient = result.GetValue(command.WaitForClient),
            Fragment = result.GetValue(command.Fragment),
        };
    }

    private static int? GetCalculationPort(SimulatorCommand command, ParseResult result, string[] udp)
    {
        int? port = result.GetResult(command.CalculationPort) is null ? null : result.GetValue(command.CalculationPort);
        return udp.Length > 0 && port == 0
            ? throw new UsageException("--calculation-port 0 takes a free port to listen on; with --udp it is a port to send to, from 1 to 65535.")
            : port;
    }

    private static void CheckFormat(SimulatorCommand command, ParseResult result, BroadcastFormat format)
    {
        HeaderLayout? header = result.GetValue(command.Header);
        if (format == BroadcastFormat.Text && header is not null)
            throw new UsageException("--format text has no headers: leave out --header.");
        if (format == BroadcastFormat.Studio && header == HeaderLayout.Old)
            throw new UsageException("--format studio has the new header; Axis Studio's old one is --format binary --header old.");
        if (format != BroadcastFormat.Text && result.GetValue(command.Decimals) is not null)
            throw new UsageException("--decimals is for --format text; packets carry every value as it is.");
    }

    private static void CheckPorts(params (string Option, int? Port)[] ports)
    {
        foreach (IGrouping<int?, string> same in ports.Where(port => port.Port > 0).GroupBy(port => port.Port, port => port.Option))
        {
            if (same.Count() > 1)
                throw new UsageException($"{string.Join(" and ", same)} are both {same.Key}; each takes a port of its own.");
        }
    }

    private static IPEndPoint Resolve(string destination)
    {
        int colon = destination.LastIndexOf(':');
        string host = colon < 0 ? string.Empty : destination[..colon].Trim('[', ']');
        if (host.Length == 0 || !ushort.TryParse(destination.AsSpan(colon + 1), out ushort port) || port == 0)
            throw new UsageException($"--udp {destination} is not of the form HOST:PORT.");
        if (IPAddress.TryParse(host, out IPAddress? address))
            return new IPEndPoint(address, port);

        try
        {
            // IPv4 first: the vendor's readers bind to nothing else (protocol.md section 4.2).
            IPAddress[] addresses = Dns.GetHostAddresses(host);
            return new IPEndPoint(addresses.OrderBy(candidate => candidate.AddressFamily != AddressFamily.InterNetwork).First(), port);
        }
        catch (SocketException exception)
        {
            throw new SimulatorException($"--udp: the host name {host} leads nowhere ({exception.SocketErrorCode}).");
        }
    }
}
