using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

public sealed partial class ReceiveThreadTests : IDisposable
{
    private readonly TestServer _server = new();

    public void Dispose() => _server.Dispose();

    [Theory]
    [InlineData(ReceiveThread.Auto)]
    [InlineData(ReceiveThread.Dedicated)]
    [InlineData(ReceiveThread.Pool)]
    public async Task The_status_names_the_receive_thread(ReceiveThread wanted)
    {
        NeuronReaderOptions options = _server.Options();
        options.ReceiveThread = wanted;
        using var reader = new NeuronReader(options);
        bool? isPooled = null;
        reader.MotionReceived += _ => isPooled = Thread.CurrentThread.IsThreadPoolThread;
        Assert.Null(reader.Status.ReceiveThread);
        await reader.StartAsync().Soon();
        using TestConnection connection = await _server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        await reader.WaitForFramesAsync(1);

        Assert.Equal(isPooled == true ? ReceiveThread.Pool : ReceiveThread.Dedicated, reader.Status.ReceiveThread);
        if (wanted == ReceiveThread.Dedicated)
            Assert.False(isPooled);
    }

    [Fact]
    public async Task A_udp_port_is_received_on_the_pool_on_request()
    {
        await using UdpEnd end = await UdpEnd.StartAsync(static options => options.ReceiveThread = ReceiveThread.Pool);
        Assert.Equal(ReceiveThread.Pool, end.Reader.Status.ReceiveThread);
    }

    [Fact]
    public void An_unknown_thread_option_is_refused()
    {
        var exception = Assert.Throws<ArgumentException>(() => new NeuronReader(new NeuronReaderOptions { ReceiveThread = (ReceiveThread)3 }));
        Assert.Contains("ReceiveThread", exception.Message, StringComparison.Ordinal);
    }
}
