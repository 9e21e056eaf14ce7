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
