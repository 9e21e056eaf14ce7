using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

// Alone, because it counts the threads of the process.
[Collection(nameof(Alone))]
public sealed class ManyReadersTests
{
    private const int Readers = 40;
    private const int MaxThreads = 16;
    private const int Frames = 200;

    [Fact]
    public async Task Many_readers_share_few_threads_and_get_every_frame()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Only Linux tells the names of threads.");
        byte[] bytes = TestPackets.Motions(0, Frames);
        using var server = new TestServer();
        List<NeuronReader> readers = [];
        List<TestConnection> connections = [];
        try
        {
            for (int i = 0; i < Readers; i++)
            {
                readers.Add(new NeuronReader(server.Options()));
                readers[i].Start();
                connections.Add(await server.AcceptAsync());
            }

            await Task.WhenAll(connections.Select(connection => connection.SendPiecesAsync(bytes, 5000)));
            foreach (NeuronReader reader in readers)
                await reader.WaitForFramesAsync(Frames);

            Assert.All(readers, reader => Assert.Equal(
                ((long)Frames, 0L, 0L),
                (reader.GetStatistics().MotionFrames, reader.GetStatistics().Lost, reader.GetStatistics().BytesSkipped)));

            // Connecting threads may take a moment to end. Receiving threads stay.
            await Limits.UntilAsync(() => ProcessResources.TcpThreads is > 0 and <= MaxThreads);
        }
        finally
        {
            connections.ForEach(static connection => connection.Dispose());
            await Task.WhenAll(readers.Select(reader => reader.DisposeAsync().AsTask()));
        }
    }
}
