namespace NeuronMocap.Tests.Infrastructure;

internal sealed partial class FedStream
{
    public override ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellationToken = default)
    {
        if (buffer.IsEmpty && EmptyRead is { } read)
            return new ValueTask<int>(read());

        return BlocksCallers ? new ValueTask<int>(ReadBlocking(buffer.Span)) : WaitAsync(buffer, cancellationToken);
    }

    private int ReadBlocking(Span<byte> destination)
    {
        byte[] buffer = new byte[destination.Length];
        int count = Read(buffer, 0, buffer.Length);
        buffer.AsSpan(0, count).CopyTo(destination);
        return count;
    }

    private async ValueTask<int> WaitAsync(Memory<byte> buffer, CancellationToken cancellationToken)
    {
        while (true)
        {
            Task changed;
            lock (_lock)
            {
                if (TryTake(buffer.Span) is { } taken)
                    return taken;

                changed = _changed.Task;
                Waiting++;
            }

            await (IgnoresEnd ? changed : changed.WaitAsync(cancellationToken));
        }
    }
}
