using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server;

namespace NeuronMocap.Tool.Simulate;

/// <summary>
/// Describes why a port or a destination is not available. The text names options of the program instead of members of the library.
/// </summary>
internal static class StartFailure
{
    /// <summary>Describes why the broadcast could not start.</summary>
    /// <param name="exception">The exception.</param>
    /// <param name="options">The options of the broadcast.</param>
    public static string Describe(BroadcasterException exception, BroadcasterOptions options) => exception.Setting switch
    {
        nameof(BroadcasterOptions.Port) => DescribePort("--port", options.Port, options.BindAddress, exception),
        nameof(BroadcasterOptions.CalculationPort) => DescribePort("--calculation-port", options.CalculationPort, options.BindAddress, exception),
        nameof(BroadcasterOptions.BindAddress) => DescribeAddress("--bind", options.BindAddress, exception),
        _ => $"--udp: this computer has no route to {string.Join(" or ", options.UdpDestinations)} ({CodeOf(exception)}).",
    };

    /// <summary>Describes why the command channel could not start.</summary>
    /// <param name="exception">The exception.</param>
    /// <param name="port">The port of the command channel.</param>
    /// <param name="address">The address to listen on.</param>
    public static string DescribeCommands(BroadcasterException exception, int port, IPAddress address) =>
        exception.Setting is nameof(CommandServerOptions.Port) ? DescribePort("--command-port", port, address, exception) : DescribeAddress("--bind", address, exception);

    /// <summary>Describes why an argument that names a port to listen on or a destination cannot be used.</summary>
    /// <param name="exception">The exception.</param>
    /// <param name="argument">The argument.</param>
    /// <param name="endPoint">Its address and port.</param>
    public static string DescribeArgument(BroadcasterException exception, string argument, IPEndPoint endPoint) => exception.Setting switch
    {
        nameof(BroadcasterOptions.Port) => DescribePort(argument, endPoint.Port, endPoint.Address, exception),
        nameof(BroadcasterOptions.BindAddress) => DescribeAddress(argument, endPoint.Address, exception),
        _ => $"{argument}: this computer has no route to {endPoint} ({CodeOf(exception)}).",
    };

    private static string DescribePort(string option, int? port, IPAddress address, BroadcasterException exception) =>
        CodeOf(exception) == SocketError.AccessDenied
            ? $"{option}: this user may not listen on port {port}; choose a port from 1024 up (0 takes any free port)."
            : $"{option}: port {port} on {address} is in use by another program; close that program, or choose another port (0 takes any free port).";

    private static string DescribeAddress(string option, IPAddress address, BroadcasterException exception) =>
        $"{option}: this computer cannot listen on {address} ({CodeOf(exception)}); use an address of this computer, or 0.0.0.0 for all of them.";

    private static SocketError? CodeOf(BroadcasterException exception) => (exception.InnerException as SocketException)?.SocketErrorCode;
}
