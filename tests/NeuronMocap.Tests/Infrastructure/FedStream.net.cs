namespace NeuronMocap.Tests.Infrastructure;

internal sealed partial class FedStream
{
    public override async ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellationToken = default)
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
