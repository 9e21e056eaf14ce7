using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Server;

/// <summary>
/// The exception that a <see cref="Broadcaster"/> throws when its port or destination is not available. The message says which setting to change.
/// </summary>
public sealed class BroadcasterException : NeuronException
{
    /// <summary>Creates an exception without a message.</summary>
    public BroadcasterException()
    {
    }

    /// <summary>Creates an exception with a message.</summary>
    /// <param name="message">What happened and what to do.</param>
    public BroadcasterException(string message)
        : base(message)
    {
    }

    /// <summary>Creates an exception with a message and a cause.</summary>
    /// <param name="message">What happened and what to do.</param>
    /// <param name="innerException">The cause.</param>
    public BroadcasterException(string message, Exception innerException)
        : base(message, innerException)
    {
    }

    private BroadcasterException(string setting, string message, SocketException cause)
        : base(message, cause) => Setting = setting;

    /// <summary>Name of the member of <see cref="BroadcasterOptions"/> to check. Empty if no setting is the cause.</summary>
    public string Setting { get; } = string.Empty;

    internal static BroadcasterException CannotListen(IPEndPoint endPoint, string portSetting, SocketException cause) => cause.SocketErrorCode switch
    {
        SocketError.AddressAlreadyInUse => new BroadcasterException(
            portSetting,
            $"Port {endPoint.Port} on {endPoint.Address} is in use by another program. "
            + $"Close that program, or choose another {portSetting} (0 takes any free port).",
            cause),
        SocketError.AccessDenied => new BroadcasterException(
            portSetting,
            $"This user may not listen on port {endPoint.Port}. Choose a {portSetting} from 1024 up (0 takes any free port).",
            cause),
        _ => new BroadcasterException(
            nameof(BroadcasterOptions.BindAddress),
            $"This computer cannot listen on the address {endPoint.Address} ({cause.SocketErrorCode}). "
            + "Set BindAddress to an address of this computer, or to 0.0.0.0 for all of them.",
            cause),
    };

    internal static BroadcasterException CannotSend(IPEndPoint destination, SocketException cause) => new(
        nameof(BroadcasterOptions.UdpDestinations),
        $"This computer has no route to {destination} ({cause.SocketErrorCode}). Check UdpDestinations and the network.",
        cause);
}
