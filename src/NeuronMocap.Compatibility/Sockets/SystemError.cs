using System.Net.Sockets;

namespace NeuronMocap.Compatibility.Sockets;

// The number at the end of the last error.
internal static class SystemError
{
    public static int CodeOf(ConnectionReason reason) => CodeOf(reason switch
    {
        ConnectionReason.Refused => SocketError.ConnectionRefused,
        ConnectionReason.TimedOut => SocketError.TimedOut,
        ConnectionReason.HostNotFound => SocketError.HostNotFound,
        ConnectionReason.Unreachable => SocketError.HostUnreachable,
        ConnectionReason.Reset => SocketError.ConnectionReset,
        ConnectionReason.PortInUse => SocketError.AddressAlreadyInUse,
        ConnectionReason.AddressUnavailable => SocketError.AddressNotAvailable,
        ConnectionReason.AccessDenied => SocketError.AccessDenied,
        _ => SocketError.SocketError,
    });

    public static int InvalidArgument => CodeOf(SocketError.InvalidArgument);

    // The system's own number if it has one. A name without an address is not a socket error and has Windows' number on all systems.
    private static int CodeOf(SocketError error) => error is SocketError.HostNotFound or SocketError.SocketError
        ? (int)error
        : new SocketException((int)error).ErrorCode;
}
