using System.IO.Pipelines;
using Microsoft.AspNetCore.Http;
using Microsoft.AspNetCore.Http.Features;

namespace NeuronMocap.AspNetCore.Tests.WebSockets;

public sealed class LimitedInputTests
{
    [Theory]
    [InlineData(0)]
    [InlineData(LimitedInput.MostBytes + 1)]
    public async Task A_read_ends_with_its_token_and_the_next_one_works(int sent)
    {
        var pipe = new Pipe();
        var context = new DefaultHttpContext();
        context.Features.Set<IHttpUpgradeFeature>(new Connection(pipe.Reader.AsStream()));
        await LimitedInput.InsertAsync(context, static _ => Task.CompletedTask);
        using LimitedInput input = context.Features.GetRequiredFeature<LimitedInput>();
        await using Stream stream = await context.Features.GetRequiredFeature<IHttpUpgradeFeature>().UpgradeAsync();

        // A client that has sent too much waits without a read.
        byte[] buffer = new byte[LimitedInput.MostBytes + 1];
        await pipe.Writer.WriteAsync(new byte[sent], TestContext.Current.CancellationToken);
        if (sent > 0)
            await stream.ReadExactlyAsync(buffer.AsMemory(0, sent), TestContext.Current.CancellationToken).AsTask().Soon();

        using var source = new CancellationTokenSource();
        Task<int> reading = stream.ReadAsync(buffer, source.Token).AsTask();
        Assert.False(reading.IsCompleted);
        await source.CancelAsync();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => reading.Soon());

        Task<int> next = stream.ReadAsync(buffer, TestContext.Current.CancellationToken).AsTask();
        if (sent == 0)
        {
            await pipe.Writer.WriteAsync(new byte[3], TestContext.Current.CancellationToken);
            Assert.Equal(3, await next.Soon());
            next = stream.ReadAsync(buffer, TestContext.Current.CancellationToken).AsTask();
        }

        input.End();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => next.Soon());
    }

    private sealed class Connection(Stream stream) : IHttpUpgradeFeature
    {
        public bool IsUpgradableRequest => true;

        public Task<Stream> UpgradeAsync() => Task.FromResult(stream);
    }
}
