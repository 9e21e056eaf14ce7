using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Server;

/// <summary>
/// A <see cref="Broadcaster"/> could not take its port or reach its destination; the message says which setting to change.
/// </summary>
public sealed class BroadcasterException : NeuronException
{
    /// <summary>Makes an exception without a message.</summary>
    public BroadcasterException()
    {
    }

    /// <summary>Makes an exception.</summary>
    /// <param name="message">What happened and what to do.</param>
    public BroadcasterException(string message)
        : base(message)
    {
    }

    /// <summary>Makes an exception with a cause.</summary>
    /// <param name="message">What happened and what to do.</param>
    /// <param name="innerException">The cause.</param>
    public BroadcasterException(string message, Exception innerException)
        : base(message, innerException)
    {
    }

    private BroadcasterException(string setting, string message, SocketException cause)
        : base(message, cause) => Setting = setting;

    /// <summary>Name of the member of <see cref="BroadcasterOptions"/> to look at; empty when there is none.</summary>
    public string Setting { get; } = string.Empty;

    internal static BroadcasterException CannotListen(IPEndPoint endPoint, string portSetting, SocketException cause) => cause.SocketErrorCode switch
    {
        SocketError.AddressAlreadyInUse => new BroadcasterException(
            portSetting,
            $"Port {endPoint.Port} on {endPoint.Address} is used by another program; "
            + $"end that one, or choose another {portSetting} (0 takes any free one).",
            cause),
        SocketError.AccessDenied => new BroadcasterException(
            portSetting,
            $"This user may not listen on port {endPoint.Port}; choose a {portSetting} from 1024 up (0 takes any free one).",
            cause),
        _ => new BroadcasterException(
            nameof(BroadcasterOptions.BindAddress),
            $"This machine cannot listen on the address {endPoint.Address} ({cause.SocketErrorCode}); "
            + "set BindAddress to one of its own, or to 0.0.0.0 for all.",
            cause),
    };

    internal static BroadcasterException CannotSend(IPEndPoint destination, SocketException cause) => new(
        nameof(BroadcasterOptions.UdpDestinations),
        $"This machine has no route to {destination}; check UdpDestinations and the network ({cause.SocketErrorCode}).",
        cause);
}
