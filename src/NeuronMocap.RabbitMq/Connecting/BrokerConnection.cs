using System.Collections.Concurrent;
using RabbitMQ.Client;

namespace NeuronMocap.RabbitMq.Connecting;

// A connection and its only channel. Neither recovers by itself: publishers and readers open new ones, because what was on the way must be counted.
internal sealed class BrokerConnection
{
    // A broker that is gone without a word is noticed after two of them.
    private static readonly TimeSpan Heartbeat = TimeSpan.FromSeconds(10);
    private static readonly TimeSpan CloseTimeout = TimeSpan.FromSeconds(2);

    private BrokerConnection(IConnection connection, IChannel channel) => (Connection, Channel) = (connection, channel);

    public IConnection Connection { get; }

    public IChannel Channel { get; }

    // Throws a NeuronConnectionException with one sentence.
    public static async Task<BrokerConnection> OpenAsync(RabbitMqOptions options, string name, CreateChannelOptions? channelOptions, CancellationToken cancellationToken)
    {
        using var timeoutSource = CancellationTokenSource.CreateLinkedTokenSource(cancellationToken);
        var sockets = new ConcurrentBag<BrokerSocket>();
        Task<BrokerConnection> opening = OpenCoreAsync(options, name, channelOptions, sockets, timeoutSource.Token);
        await TaskAbandoning.WaitAsync(opening, options.ConnectTimeout, cancellationToken).ConfigureAwait(false);
        if (!opening.IsCompleted)
        {
            timeoutSource.Cancel();
            Close(sockets);
            TaskAbandoning.Abandon(opening, static late => late.Close());
            cancellationToken.ThrowIfCancellationRequested();
            throw BrokerFault.TimedOut(options);
        }

        try
        {
            return await opening.ConfigureAwait(false);
        }
        catch (Exception exception) when (exception is not OperationCanceledException || !cancellationToken.IsCancellationRequested)
        {
            Close(sockets);
            throw BrokerFault.Of(exception, options);
        }
    }

    // Sends what waits, then closes. Returns after a limited time.
    public async Task CloseAsync()
    {
        Task closing = CloseCoreAsync();
        await TaskAbandoning.WaitAsync(closing, CloseTimeout + CloseTimeout, CancellationToken.None).ConfigureAwait(false);
    }

    private static async Task<BrokerConnection> OpenCoreAsync(
        RabbitMqOptions options,
        string name,
        CreateChannelOptions? channelOptions,
        ConcurrentBag<BrokerSocket> sockets,
        CancellationToken cancellationToken)
    {
        var factory = new ConnectionFactory
        {
            HostName = options.Host,
            Port = options.Port,
            UserName = options.UserName,
            Password = options.Password,
            VirtualHost = options.VirtualHost,
            AutomaticRecoveryEnabled = false,
            TopologyRecoveryEnabled = false,
            RequestedHeartbeat = Heartbeat,
            // The caller of this method ends the attempt in time. The client itself says less about the reason.
            RequestedConnectionTimeout = options.ConnectTimeout + options.ConnectTimeout,
            HandshakeContinuationTimeout = options.ConnectTimeout + options.ConnectTimeout,
            ContinuationTimeout = options.ConnectTimeout,
            ClientProvidedName = name,
            SocketFactory = family =>
            {
                var socket = new BrokerSocket(family);
                sockets.Add(socket);
                return socket;
            },
        };
        IConnection connection = await factory.CreateConnectionAsync(cancellationToken).ConfigureAwait(false);
        try
        {
            // A broker refuses a virtual host only now.
            return new BrokerConnection(connection, await connection.CreateChannelAsync(channelOptions, cancellationToken).ConfigureAwait(false));
        }
        catch
        {
            await CloseAsync(connection).ConfigureAwait(false);
            throw;
        }
    }

    // The client leaves the socket of a failed attempt open.
    private static void Close(IEnumerable<BrokerSocket> sockets)
    {
        foreach (BrokerSocket socket in sockets)
            socket.Close();
    }

    private static async Task CloseAsync(IConnection connection)
    {
        try
        {
            await connection.CloseAsync(Constants.ReplySuccess, "Goodbye", CloseTimeout, abort: true).ConfigureAwait(false);
            await connection.DisposeAsync().ConfigureAwait(false);
        }
        catch (Exception)
        {
            // What the connection does at its end no longer matters.
        }
    }

    private Task CloseCoreAsync() => CloseAsync(Connection);

    private void Close() => _ = CloseCoreAsync();
}
