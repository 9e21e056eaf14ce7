using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server;

namespace NeuronMocap.Tool.Simulate;

/// <summary>Describes why a port or a destination is not available. The text names options of the program instead of members of the
/// library.</summary>
internal static class StartFailure
{
    /// <summary>Describes why the broadcast could not start.</summary>
    /// <param name="exception">The exception.</param>
    /// <param name="options">The options of the broadcast.</param>
    public static string Describe(BroadcasterException exception, BroadcasterOptions options) => exception.Setting switch
    {
        nameof(BroadcasterOptions.Port) => DescribePort("--port", options.Port, options.BindAddress, exception),
        nameof(BroadcasterOptions.CalculationPort) => DescribePort("--calculation-port", options.CalculationPort, options.BindAddress, exception),
        nameof(BroadcasterOptions.BindAddress) => DescribeAddress(options.BindAddress, exception),
        _ => $"--udp: this machine has no route to {string.Join(" or ", options.UdpDestinations)} ({CodeOf(exception)}).",
    };

    /// <summary>Describes why the command channel could not start.</summary>
    /// <param name="exception">The exception.</param>
    /// <param name="port">The port of the command channel.</param>
    /// <param name="address">The address to listen on.</param>
    public static string DescribeCommands(BroadcasterException exception, int port, IPAddress address) =>
        exception.Setting is nameof(CommandServerOptions.Port) ? DescribePort("--commands", port, address, exception) : DescribeAddress(address, exception);

    private static string DescribePort(string option, int? port, IPAddress address, BroadcasterException exception) =>
        CodeOf(exception) == SocketError.AccessDenied
            ? $"{option}: this user may not listen on port {port}; choose one from 1024 up (0 takes any free one)."
            : $"{option}: port {port} on {address} is used by another program; end that one, or choose another port (0 takes any free one).";

    private static string DescribeAddress(IPAddress address, BroadcasterException exception) =>
        $"--bind: this machine cannot listen on {address} ({CodeOf(exception)}); give one of its own addresses, or 0.0.0.0 for all.";

    private static SocketError? CodeOf(BroadcasterException exception) => (exception.InnerException as SocketException)?.SocketErrorCode;
}
