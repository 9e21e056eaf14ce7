using System.Net.Sockets;

namespace NeuronMocap.Transport;

internal static class SocketErrors
{
    public static ConnectionReason ToReason(SocketError error) => error switch
    {
        SocketError.ConnectionRefused => ConnectionReason.Refused,
        SocketError.TimedOut => ConnectionReason.TimedOut,
        SocketError.HostNotFound or SocketError.NoData or SocketError.TryAgain or SocketError.NoRecovery => ConnectionReason.HostNotFound,
        SocketError.NetworkUnreachable or SocketError.HostUnreachable or SocketError.HostDown or SocketError.NetworkDown => ConnectionReason.Unreachable,
        SocketError.ConnectionReset or SocketError.ConnectionAborted or SocketError.NetworkReset or SocketError.Shutdown => ConnectionReason.Reset,
        SocketError.AddressAlreadyInUse => ConnectionReason.PortInUse,
        SocketError.AddressNotAvailable => ConnectionReason.AddressUnavailable,
        SocketError.AccessDenied => ConnectionReason.AccessDenied,
        _ => ConnectionReason.NetworkError,
    };

    // Closing a socket during a pending operation causes a different exception on every runtime.
    public static bool IsExpected(Exception exception) =>
        exception is SocketException or ObjectDisposedException or OperationCanceledException;
}
