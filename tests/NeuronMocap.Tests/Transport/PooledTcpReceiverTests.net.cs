using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Transport;

public sealed class PooledTcpReceiverTests : TcpReceiverTests
{
    internal override TcpReceiver Create() => new PooledTcpReceiver();

    [Fact]
    public void The_number_of_connection_threads_is_limited()
    {
        var receivers = new TcpReceivers(new ReceiveThreads(limit: 2));
        TcpReceiver first = receivers.Take();
        TcpReceiver second = receivers.Take();
        Assert.IsType<PooledTcpReceiver>(receivers.Take());
        Assert.IsType<PooledTcpReceiver>(receivers.Take());

        first.Close();
        Assert.IsType<BlockingTcpReceiver>(receivers.Take());
        Assert.IsType<PooledTcpReceiver>(receivers.Take());
        Assert.IsType<BlockingTcpReceiver>(first);
        Assert.IsType<BlockingTcpReceiver>(second);
    }

    [Fact]
    public void Explicit_thread_options_ignore_the_limit()
    {
        var receivers = new TcpReceivers(new ReceiveThreads(limit: 1));
        Assert.IsType<PooledTcpReceiver>(receivers.Take(ReceiveThread.Pool));
        TcpReceiver first = receivers.Take(ReceiveThread.Dedicated);
        TcpReceiver second = receivers.Take(ReceiveThread.Dedicated);
        Assert.IsType<BlockingTcpReceiver>(first);
        Assert.IsType<BlockingTcpReceiver>(second);
        Assert.IsType<PooledTcpReceiver>(receivers.Take());

        first.Close();
        Assert.IsType<PooledTcpReceiver>(receivers.Take());
        second.Close();
        Assert.IsType<BlockingTcpReceiver>(receivers.Take());
    }

    [Fact]
    public async Task A_closed_link_returns_its_thread()
    {
        var receivers = new TcpReceivers(new ReceiveThreads(limit: 1));
        using var server = new TestServer();
        for (int i = 0; i < 3; i++)
        {
            using var link = new TcpLink(new LinkOptions("127.0.0.1", server.Port) { TakeReceiver = receivers.Take });
            Assert.Equal(ConnectionReason.None, (await link.OpenAsync(CancellationToken.None).Soon()).Reason);
            Assert.IsType<PooledTcpReceiver>(receivers.Take());
        }

        Assert.IsType<BlockingTcpReceiver>(receivers.Take());
    }
}
