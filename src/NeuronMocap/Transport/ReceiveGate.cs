namespace NeuronMocap.Transport;

// Stands before what a link delivers, where pool threads deliver it: one of them at a time goes through, and none after the end. So a link that is
// closed is over as soon as nobody is inside, which whoever closes it finds out here, without waiting for the system to complete an operation
// on a pool thread that may not be free for a while.
internal sealed class ReceiveGate
{
    private const int Open = 0;
    private const int Inside = 1;
    private const int Closed = 2;

    // Whoever awaits it goes on on the thread that closes the gate.
    private readonly TaskCompletionSource<bool> _closed = new();
    private int _state;

    // Before a delivery. False at the end.
    public bool TryEnter() => Interlocked.CompareExchange(ref _state, Inside, Open) == Open;

    // After one. False when the gate was closed meanwhile, or before.
    public bool TryLeave() => Interlocked.CompareExchange(ref _state, Open, Inside) == Inside;

    public void Close()
    {
        if (Interlocked.Exchange(ref _state, Closed) == Open)
            _closed.TrySetResult(true);
    }

    // Ends as the deliveries do, or when the gate is closed and nobody is inside.
    public async Task UntilClosedAsync(Task deliveries)
    {
        if (await Task.WhenAny(deliveries, _closed.Task).ConfigureAwait(false) == deliveries)
        {
            await deliveries.ConfigureAwait(false);
            return;
        }

        _ = deliveries.ContinueWith(static task => _ = task.Exception, TaskContinuationOptions.OnlyOnFaulted);
        throw new OperationCanceledException();
    }
}
