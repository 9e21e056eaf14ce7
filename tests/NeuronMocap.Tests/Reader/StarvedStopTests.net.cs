using System.IO.Pipelines;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Reader;

// Waiting without a thread, which only this target supports.
public sealed partial class StarvedStopTests
{
    [Fact]
    public async Task While_a_pipe_waits()
    {
        var reader = new NeuronReader(new Pipe().Reader, SourceReaderTests.Options());
        await reader.StartAsync().Soon();
        await StopAsync(reader);
    }

    [Fact]
    public Task While_connecting_without_a_thread() => WhileConnectingAsync(() => new PooledTcpReceiver());

    [Theory]
    [InlineData(0)]
    [InlineData(2000)]
    public Task While_connected_without_a_thread(int bytes) => WhileConnectedAsync(bytes, () => new PooledTcpReceiver());
}
