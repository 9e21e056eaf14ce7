using System.Globalization;
using Microsoft.AspNetCore.Connections;
using Microsoft.AspNetCore.Connections.Features;
using Microsoft.Extensions.Logging;
using NeuronMocap.Server.Clients;

namespace NeuronMocap.AspNetCore.Connections;

/// <summary>Starts to serve a connection. The task ends with it. Returns false if there is no place for the client.</summary>
internal delegate bool Serve(ClientTransport transport, out Task served);

/// <summary>Serves the connections of one address of Kestrel.</summary>
/// <param name="serve">Starts to serve a connection.</param>
/// <param name="sendTimeout">Time after which a client that does not read is given up.</param>
/// <param name="logger">Receives why a connection is refused.</param>
internal sealed class NeuronConnectionHandler(Serve serve, TimeSpan sendTimeout, ILogger logger)
{
    // Kestrel still has to send what is left. A client that does not read must not hold up the end of the server.
    private static readonly TimeSpan CloseTimeout = TimeSpan.FromSeconds(5);

    private static readonly Action<ILogger, string, string, Exception?> LogRefusal = LoggerMessage.Define<string, string>(
        LogLevel.Warning, new EventId(1, "ClientRefused"), "Refused {Client}: {Reason}");

    public async Task RunAsync(ConnectionContext connection)
    {
        ConnectionSocket.Prepare(connection.Features);
        using var transport = new PipeTransport(connection, sendTimeout);
        try
        {
            if (!serve(transport, out Task served))
            {
                Refuse(connection, "the server has no room for another client, or has been stopped.");
                return;
            }

            // The application stops. A client that has closed its own side may still read.
            CancellationToken stopping = connection.Features.Get<IConnectionLifetimeNotificationFeature>()?.ConnectionClosedRequested ?? CancellationToken.None;
            using (stopping.Register(transport.Dispose))
            using (EndWithTls(connection, transport))
                await served.ConfigureAwait(false);
        }
        catch (NeuronConnectionException exception)
        {
            Refuse(connection, exception.Message);
        }

        _ = AbortLaterAsync(connection);
    }

    // TLS has no half-closed connections, and hides from the sender that the client is gone.
    private static CancellationTokenRegistration EndWithTls(ConnectionContext connection, PipeTransport transport) =>
        connection.Features.Get<ITlsHandshakeFeature>() is null ? default : connection.ConnectionClosed.Register(transport.Dispose);

    private void Refuse(ConnectionContext connection, string reason) =>
        LogRefusal(logger, string.Create(CultureInfo.InvariantCulture, $"{connection.RemoteEndPoint}"), reason, null);

    private static async Task AbortLaterAsync(ConnectionContext connection)
    {
        await Task.Delay(CloseTimeout).ConfigureAwait(false);
        connection.Abort(new ConnectionAbortedException("The client did not read the end of the stream."));
    }
}
