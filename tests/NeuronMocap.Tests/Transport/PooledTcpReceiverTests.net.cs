using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Transport;

public sealed class PooledTcpReceiverTests : TcpReceiverTests
{
    internal override TcpReceiver Create() => new PooledTcpReceiver();

    [Fact]
    public void Only_so_many_connections_have_a_thread()
    {
        var receivers = new TcpReceivers(maxThreads: 2);
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
    public void Who_wants_a_thread_or_none_gets_it_whatever_the_limit()
    {
        var receivers = new TcpReceivers(maxThreads: 1);
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
    public async Task A_link_gives_its_thread_back_when_it_is_closed()
    {
        var receivers = new TcpReceivers(maxThreads: 1);
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
