using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Transport;

namespace NeuronMocap.Server.Clients;

/// <summary>One client of a command relay, and its connection to the server. Disposing it ends both.</summary>
/// <param name="client">The connection of the client, which the session owns.</param>
/// <param name="options">Where the server is.</param>
/// <param name="listener">Where the relay listens.</param>
/// <param name="getTimestamp">Returns the time in ticks of <see cref="System.Diagnostics.Stopwatch"/>.</param>
/// <param name="ended">Called once at the end, on a pool thread.</param>
/// <param name="report">Receives the reason if the server cannot be reached.</param>
internal sealed class CommandRelaySession(
    Socket client, CommandRelayOptions options, IPEndPoint listener, Func<long> getTimestamp, Action<ICommandSession> ended, FaultReport report) : ICommandSession
{
    // Real requests have a few bytes, and most replies fit.
    private const int BufferSize = 16 * 1024;

    private readonly Socket _server = new(SocketType.Stream, ProtocolType.Tcp);
    private volatile bool _isDisposed;

    public IdleClock Idle { get; } = new(options.IdleTimeout, getTimestamp);

    public bool IsLeft => _isDisposed;

    // Uses pool threads, and only while bytes pass.
    public Worker? Start()
    {
        _ = Task.Run(RunAsync);
        return null;
    }

    public void Dispose()
    {
        _isDisposed = true;
        client.Dispose();
        _server.Dispose();
    }

    private async Task RunAsync()
    {
        Exception? failure = null;
        try
        {
            await ConnectAsync().ConfigureAwait(false);
            await PassAsync().ConfigureAwait(false);
        }
        catch (Exception exception) when (!_isDisposed)
        {
            failure = exception;
        }
        catch (Exception)
        {
            // The relay was stopped, or another client took the place.
        }

        Dispose();
        ended(this);
        if (failure is not null)
            report.Report(failure);
    }

    // Passes bytes until one side ends the connection, or until none have passed for long.
    private async Task PassAsync()
    {
        using var over = new CancellationTokenSource();
        try
        {
            foreach (Socket socket in (Socket[])[client, _server])
            {
                socket.NoDelay = true;
                TcpKeepAlive.Enable(socket);
            }

            // A client that has sent its last request still gets its replies.
            Idle.Restart();
            _ = EndWhenIdleAsync(over.Token);
            Task requests = PassAsync(client, _server, OnRequest);
            Task replies = PassAsync(_server, client, Idle.Restart);
            await (await Task.WhenAny(requests, replies).ConfigureAwait(false)).ConfigureAwait(false);
            await replies.ConfigureAwait(false);
        }
        catch (Exception exception) when (SocketErrors.IsExpected(exception))
        {
            // One side reset its connection, or it was closed here. All are ordinary ends.
        }
        finally
        {
            over.Cancel();
        }
    }

    // Bytes are not interpreted, so any of them count.
    private void OnRequest()
    {
        Idle.Stop();
        Idle.Restart();
    }

    private async Task EndWhenIdleAsync(CancellationToken over)
    {
        try
        {
            while (Idle.GetRest() is { } rest)
                await Task.Delay(rest == 0 ? Timeout.Infinite : rest, over).ConfigureAwait(false);

            Dispose();
        }
        catch (OperationCanceledException)
        {
            // The session has ended.
        }
    }

    private async Task ConnectAsync()
    {
        string target = $"{options.Host}:{options.HostPort}";
        try
        {
            Task connecting = _server.ConnectAsync(options.Host, options.HostPort);
            if (await Task.WhenAny(connecting, Task.Delay(options.ConnectTimeout)).ConfigureAwait(false) != connecting)
                _server.Dispose();

            await connecting.ConfigureAwait(false);
        }
        catch (Exception exception) when (SocketErrors.IsExpected(exception))
        {
            string reason = exception is SocketException { SocketErrorCode: var code } ? code.ToString() : nameof(SocketError.TimedOut);
            throw new BroadcasterException($"The command channel of {target} cannot be reached ({reason}). Check its address and port, and that it runs.", exception);
        }

        if (IsOwnPort((IPEndPoint)_server.LocalEndPoint!, (IPEndPoint)_server.RemoteEndPoint!))
            throw new BroadcasterException($"The command channel of {target} is this relay itself. Choose another port to listen on, or another server.");
    }

    // A relay that connects to itself would use up all its connections.
    private bool IsOwnPort(IPEndPoint local, IPEndPoint remote) => remote.Equals(local)
        || (remote.Port == listener.Port && IsListening(remote.Address) && local.Address.Equals(remote.Address));

    private bool IsListening(IPAddress address) => listener.Address.Equals(IPAddress.Any) || listener.Address.Equals(IPAddress.IPv6Any)
        || listener.Address.MapToIPv6().Equals(address.MapToIPv6());

    private static async Task PassAsync(Socket from, Socket to, Action passed)
    {
        byte[] buffer = new byte[BufferSize];
        int count;
        while ((count = await from.ReceiveAsync(new ArraySegment<byte>(buffer), SocketFlags.None).ConfigureAwait(false)) > 0)
        {
            passed();
            for (int sent = 0; sent < count;)
                sent += await to.SendAsync(new ArraySegment<byte>(buffer, sent, count - sent), SocketFlags.None).ConfigureAwait(false);
        }

        to.Shutdown(SocketShutdown.Send);
    }
}
