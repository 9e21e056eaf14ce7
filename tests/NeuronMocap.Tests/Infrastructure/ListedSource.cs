namespace NeuronMocap.Tests.Infrastructure;

// A source that opens its streams one after another, and then waits forever.
internal sealed class ListedSource(params Func<Stream>[] streams) : ByteSource
{
    private int _opened;

    public override string Name => "the list";

    public int Opened => Volatile.Read(ref _opened);

    public override async ValueTask<Stream> OpenAsync(CancellationToken cancellationToken)
    {
        int place = Interlocked.Increment(ref _opened) - 1;
        if (place >= streams.Length)
            await Task.Delay(Timeout.Infinite, cancellationToken);

        return streams[place]();
    }
}
