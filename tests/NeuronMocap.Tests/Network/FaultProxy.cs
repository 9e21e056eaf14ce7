using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Tests.Network;

// A proxy between a server and its clients that disturbs the data like a bad network. A script for each connection determines how. When the script
// ends, the connection ends too.
internal sealed class FaultProxy : IAsyncDisposable
{
    private readonly TcpListener _listener = new(IPAddress.Loopback, 0);
    private readonly CancellationTokenSource _stop = new();
    private readonly IPEndPoint _server;
    private readonly Func<ProxiedConnection, Task> _script;
    private readonly Task _accepting;
    private readonly List<Task> _running = [];

    public FaultProxy(IPEndPoint server, Func<ProxiedConnection, Task> script)
    {
        _server = server;
        _script = script;
        _listener.Start();
        _accepting = Task.Run(AcceptAsync);
    }

    public int Port => ((IPEndPoint)_listener.LocalEndpoint).Port;

    // Fails if a script failed.
    public async ValueTask DisposeAsync()
    {
        await _stop.CancelAsync();
        _listener.Dispose();
        await _accepting.Soon();
        await Task.WhenAll(_running).Soon();
        _stop.Dispose();
    }

    private async Task AcceptAsync()
    {
        try
        {
            for (int number = 0; ; number++)
                _running.Add(RunAsync(await _listener.AcceptSocketAsync(_stop.Token), number));
        }
        catch (Exception exception) when (exception is OperationCanceledException or SocketException or InvalidOperationException)
        {
            // The proxy was disposed.
        }
    }

    private async Task RunAsync(Socket client, int number)
    {
        using var server = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        using var connection = new ProxiedConnection(client, server, number, _stop.Token);
        try
        {
            await server.ConnectAsync(_server, _stop.Token);
            await _script(connection);
        }
        catch (Exception exception) when (exception is OperationCanceledException or SocketException or ObjectDisposedException)
        {
            // The client left, or the test is over.
        }
    }
}

// The actions of a script on one connection.
internal sealed class ProxiedConnection(Socket client, Socket server, int number, CancellationToken cancellationToken) : IDisposable
{
    private readonly TestConnection _client = new(client);
    private readonly byte[] _buffer = new byte[64 * 1024];

    // 0 for the first connection that the proxy accepted.
    public int Number => number;

    // Forwards the next bytes of the server, in pieces of one size.
    public async Task ForwardAsync(long count, int pieceSize = int.MaxValue)
    {
        while (count > 0)
        {
            int size = (int)Math.Min(Math.Min(count, pieceSize), _buffer.Length);
            await server.ReceiveExactlyAsync(_buffer.AsMemory(0, size), cancellationToken);
            await _client.SendAsync(_buffer.AsMemory(0, size));
            count -= size;
        }
    }

    // Forwards everything that the server sends from now on.
    public async Task ForwardRestAsync()
    {
        int count;
        while ((count = await server.ReceiveAsync(_buffer, cancellationToken)) > 0)
            await _client.SendAsync(_buffer.AsMemory(0, count));
    }

    // Removes the next bytes of the server from the stream.
    public async Task DropAsync(int count)
    {
        for (int size; count > 0; count -= size)
        {
            size = Math.Min(count, _buffer.Length);
            await server.ReceiveExactlyAsync(_buffer.AsMemory(0, size), cancellationToken);
        }
    }

    // Sends bytes that the server did not send.
    public Task InjectAsync(byte[] bytes) => _client.SendAsync(bytes);

    public void HalfClose() => client.Shutdown(SocketShutdown.Send);

    public void Reset() => _client.Reset();

    // Keeps the connection open without sending, until the test is over.
    public Task HoldAsync() => Task.Delay(Timeout.Infinite, cancellationToken);

    public void Dispose() => _client.Dispose();
}

internal static class SocketExtensions
{
    public static async Task ReceiveExactlyAsync(this Socket socket, Memory<byte> buffer, CancellationToken cancellationToken)
    {
        while (buffer.Length > 0)
        {
            int count = await socket.ReceiveAsync(buffer, cancellationToken);
            if (count == 0)
                throw new SocketException((int)SocketError.ConnectionReset);

            buffer = buffer[count..];
        }
    }
}
