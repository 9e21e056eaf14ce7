using System.IO.Pipelines;

namespace NeuronMocap.Tests.Reader;

public partial class FixtureReaderTests
{
    [Theory]
    [MemberData(nameof(Names))]
    public async Task From_a_pipe(string name)
    {
        StreamFixture fixture = Load(name);
        foreach (int pieceSize in (int[])[1, 63, 777, int.MaxValue])
        {
            var pipe = new Pipe(new PipeOptions(pauseWriterThreshold: 0));
            foreach (byte[] piece in fixture.Bytes.Chunk(pieceSize))
                await pipe.Writer.WriteAsync(piece, TestContext.Current.CancellationToken);

            await pipe.Writer.CompleteAsync();
            await FromAsync(fixture, new NeuronReader(pipe.Reader, SourceReaderTests.Options()));
        }

        Stream stream = new FedStream().Feed([.. fixture.Bytes.Chunk(100)]).End();
        await FromAsync(fixture, new NeuronReader(stream, SourceReaderTests.Options(ReceiveThread.Pool)));
    }
}
