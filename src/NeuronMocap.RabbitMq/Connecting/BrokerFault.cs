using System.Net.Sockets;
using RabbitMQ.Client.Events;
using RabbitMQ.Client.Exceptions;

namespace NeuronMocap.RabbitMq.Connecting;

// What went wrong, in one sentence that names the setting. It never contains a password.
internal static class BrokerFault
{
    private const ushort ConnectionForced = 320;
    private const ushort AccessRefused = 403;
    private const ushort NotFound = 404;
    private const ushort PreconditionFailed = 406;
    private const ushort NotAllowed = 530;

    public static NeuronConnectionException TimedOut(RabbitMqOptions options) => new(
        ConnectionReason.TimedOut,
        FormattableString.Invariant($"{AmqpAddress.EndPoint(options)} did not answer as a RabbitMQ broker within {options.ConnectTimeout.TotalSeconds:0.###} s."));

    public static NeuronConnectionException Of(Exception exception, RabbitMqOptions options)
    {
        string broker = AmqpAddress.EndPoint(options);
        foreach (Exception cause in Causes(exception))
        {
            switch (cause)
            {
                case NeuronConnectionException known:
                    return known;
                case AuthenticationFailureException or PossibleAuthenticationFailureException:
                    return RefusesUser(options);
                case OperationInterruptedException { ShutdownReason: { } reason }:
                    return Of(reason, options);
                case SocketException socket:
                    return Of(socket, options);
                case MalformedFrameException or PacketNotRecognizedException or EndOfStreamException:
                    return NoBroker(broker);
            }
        }

        if (Causes(exception).Any(static cause => cause is OperationCanceledException or TimeoutException))
            return TimedOut(options);

        // The client reports bytes that are not of its protocol, and no answer, as the same exception of input and output.
        return exception is BrokerUnreachableException { InnerException: IOException }
            ? NoBroker(broker)
            : new NeuronConnectionException(ConnectionReason.NetworkError, $"The connection to {broker} failed: {exception.Message}");
    }

    public static NeuronConnectionException Of(ShutdownEventArgs reason, RabbitMqOptions options)
    {
        string broker = AmqpAddress.EndPoint(options);
        bool isHost = reason.ReplyText.Contains("vhost", StringComparison.Ordinal);
        return reason.ReplyCode switch
        {
            ConnectionForced => new(ConnectionReason.ClosedByPeer, $"The broker {broker} was shut down."),
            NotAllowed when isHost && reason.ReplyText.Contains("not found", StringComparison.Ordinal) =>
                new(ConnectionReason.NetworkError, $"The broker {broker} has no virtual host '{options.VirtualHost}'."),
            NotAllowed when isHost =>
                new(ConnectionReason.AccessDenied, $"The broker {broker} does not allow user '{options.UserName}' to use the virtual host '{options.VirtualHost}'."),
            AccessRefused when reason.ReplyText.Contains("Login was refused", StringComparison.Ordinal) => RefusesUser(options),
            AccessRefused => new(
                ConnectionReason.AccessDenied, $"The broker {broker} does not give user '{options.UserName}' the permissions for the exchange and its queues."),
            NotFound when reason.ReplyText.Contains("inaccessible", StringComparison.Ordinal) =>
                new(ConnectionReason.NetworkError, $"The broker {broker} has not opened the stream after its start ({reason.ReplyText})."),
            NotFound => new(ConnectionReason.NetworkError, $"The broker {broker} has no stream or exchange of this name ({reason.ReplyText})."),
            PreconditionFailed when reason.ReplyText.Contains("acknowledgement", StringComparison.Ordinal) => new(
                ConnectionReason.ClosedByPeer, $"The broker {broker} closed the connection, because the reader took no frames for too long ({reason.ReplyText})."),
            PreconditionFailed => new(
                ConnectionReason.NetworkError, $"The broker {broker} has a queue or exchange of this name with other settings ({reason.ReplyText})."),
            _ => new(ConnectionReason.ClosedByPeer, $"The connection to the broker {broker} was lost ({reason.ReplyText})."),
        };
    }

    private static NeuronConnectionException RefusesUser(RabbitMqOptions options) => new(
        ConnectionReason.AccessDenied, $"The broker {AmqpAddress.EndPoint(options)} refuses the user '{options.UserName}' or the password.");

    private static NeuronConnectionException NoBroker(string broker) => new(
        ConnectionReason.UnknownFormat, $"What listens on {broker} is not a RabbitMQ broker, or closed the connection while it started.");

    private static NeuronConnectionException Of(SocketException exception, RabbitMqOptions options)
    {
        string broker = AmqpAddress.EndPoint(options);
        return exception.SocketErrorCode switch
        {
            SocketError.ConnectionRefused => new(ConnectionReason.Refused, $"{broker} refused the connection: no broker listens there."),
            SocketError.HostNotFound or SocketError.NoData or SocketError.TryAgain =>
                new(ConnectionReason.HostNotFound, $"The host name '{options.Host}' has no address."),
            SocketError.TimedOut => TimedOut(options),
            SocketError.ConnectionReset => NoBroker(broker),
            SocketError.NetworkUnreachable or SocketError.HostUnreachable => new(ConnectionReason.Unreachable, $"There is no route to {broker}."),
            _ => new(ConnectionReason.NetworkError, $"The connection to {broker} failed: {exception.Message}"),
        };
    }

    // The client puts the reason under one or two exceptions that only say that no address was reached.
    private static IEnumerable<Exception> Causes(Exception exception)
    {
        for (Exception? next = exception; next is not null; next = next.InnerException)
            yield return next;
    }
}
