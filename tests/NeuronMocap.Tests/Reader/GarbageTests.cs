using System.Text;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

// Alone, because it measures the memory of the whole process.
[Collection(nameof(Alone))]
public sealed class GarbageTests
{
    private const int BlockSize = 1 << 20;
    private const int BlocksOfRound = 8;
    private const long Enough = 250_000;

    [Theory]
    [InlineData("random")]
    [InlineData("tokens")]
    [InlineData("headers")]
    [InlineData("text")]
    public async Task Endless_garbage_is_counted_in_constant_memory(string kind)
    {
        byte[] block = Block(kind);
        using var server = new TestServer();
        NeuronReaderOptions options = server.Options();
        options.SilenceTimeout = TimeSpan.FromMilliseconds(100);
        await using var reader = new NeuronReader(options);
        var log = new StatusLog(reader);
        Task<ConnectionStatus> named = log.WaitAsync(status => status is { State: ConnectionState.Silent, Reason: ConnectionReason.UnknownFormat });
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        connection.Socket.Send(block);
        connection.Socket.Send(block);

        // Covers some status messages and the test runner's own allocations, while 8 MB pass through.
        long sent = 2;
        Assert.InRange(Allocations.LeastOfProcess(SendBlocks, Enough), 0, Enough);
        while (!named.IsCompleted)
            SendBlocks();

        connection.Socket.Send(TestPackets.Motion(7));
        connection.Close();
        await reader.Completion.Soon();

        Assert.Equal((sent * BlockSize, 1L), (reader.GetStatistics().BytesSkipped, reader.GetStatistics().MotionFrames));
        Assert.Equal((sent * BlockSize) + 1480, reader.GetStatistics().BytesReceived);
        Assert.NotEmpty((await named).Message);

        void SendBlocks()
        {
            for (int i = 0; i < BlocksOfRound; i++)
                connection.Socket.Send(block);

            sent += BlocksOfRound;
        }
    }

    private static byte[] Block(string kind)
    {
        byte[] block = new byte[BlockSize];
        switch (kind)
        {
            case "random":
                new Random(3).NextBytes(block);
                break;
            case "tokens":
                for (int i = 0; i < block.Length; i += 2)
                    (block[i], block[i + 1]) = ((byte)0xFF, (byte)0xDD);

                break;
            case "headers":
                byte[] header = TestPackets.Motion(1)[..64];
                header[5] = 9; // version 9
                for (int i = 0; i < block.Length; i += header.Length)
                    header.CopyTo(block, i);

                break;
            default:
                byte[] line = Encoding.ASCII.GetBytes("0 Char00 0.00 93.02 0.00 ||   \r\n");
                for (int i = 0; i < block.Length; i += line.Length)
                    line.CopyTo(block, i);

                break;
        }

        return block;
    }
}
