using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server.Clients;

namespace NeuronMocap.Server.Tests;

public sealed class SocketTransportTests
{
    [Fact]
    public async Task Disposing_ends_the_wait_for_a_client_that_does_not_read()
    {
        (SocketTransport transport, Socket client) = Connect(Timeout.InfiniteTimeSpan);
        using (client)
        {
            Task<SocketError> sending = await FillAsync(transport);
            transport.Dispose();
            Assert.NotEqual(SocketError.Success, await sending.Soon());
        }
    }

    // In microseconds, this time does not fit into 32 bits.
    [Fact]
    public async Task A_long_time_limit_is_kept()
    {
        (SocketTransport transport, Socket client) = Connect(TimeSpan.FromMilliseconds(4_294_968));
        using (client)
        {
            Task<SocketError> sending = await FillAsync(transport);
            await client.ReceiveAsync(new byte[1 << 22], TestContext.Current.CancellationToken);
            client.Dispose();
            Assert.NotEqual(SocketError.WouldBlock, await sending.Soon());
            transport.Dispose();
        }
    }

    [Fact]
    public async Task A_client_that_does_not_read_is_given_up_after_the_time_limit()
    {
        (SocketTransport transport, Socket client) = Connect(TimeSpan.FromMilliseconds(150));
        using (client)
        using (transport)
            Assert.Equal(SocketError.WouldBlock, await (await FillAsync(transport)).Soon());
    }

    private static (SocketTransport Transport, Socket Client) Connect(TimeSpan sendTimeout)
    {
        using var listener = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        listener.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        listener.Listen();
        var client = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        client.Connect(listener.LocalEndPoint!);
        var transport = new SocketTransport(listener.Accept(), sendTimeout, sendBufferSize: 16_384);
        Assert.True(transport.TryStopWaiting());
        return (transport, client);
    }

    // Sends until an error, on another thread. Returns when the connection is full.
    private static async Task<Task<SocketError>> FillAsync(SocketTransport transport)
    {
        byte[] bytes = new byte[65_536];
        SocketError full;
        do
        {
            full = transport.TrySendNow(bytes, 0, bytes.Length, out _);
        }
        while (full == SocketError.Success);

        Assert.Equal(SocketError.WouldBlock, full);
        var begun = new TaskCompletionSource();
        Task<SocketError> sending = Task.Factory.StartNew(
            () =>
            {
                begun.SetResult();
                SocketError error;
                do
                {
                    error = Send(transport, bytes);
                }
                while (error == SocketError.Success);
                return error;
            },
            TestContext.Current.CancellationToken,
            TaskCreationOptions.LongRunning,
            TaskScheduler.Default);
        await begun.Task.Soon();
        return sending;
    }

    private static SocketError Send(SocketTransport transport, byte[] bytes)
    {
        try
        {
            return transport.TrySend(bytes, 0, bytes.Length, out _);
        }
        catch (ObjectDisposedException)
        {
            return SocketError.OperationAborted;
        }
    }
}
