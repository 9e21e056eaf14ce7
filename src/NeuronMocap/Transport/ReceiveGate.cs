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

    // Whether a delivery runs, or ended in an exception.
    public bool IsInside => Volatile.Read(ref _state) == Inside;

    // Before a delivery. False at the end. Waits for a timer that delivers what had to wait: rarely, but for as long as the handlers take that it
    // calls. So long it looks about once in a millisecond, and its thread receives nothing, as while it runs a slow handler itself.
    public bool TryEnter()
    {
        int state = Interlocked.CompareExchange(ref _state, Inside, Open);
        return state == Open || (state == Inside && WaitToEnter());
    }

    // As TryEnter, but false also while somebody is inside.
    public bool TryEnterIdle() => Interlocked.CompareExchange(ref _state, Inside, Open) == Open;

    // After one. False when the gate was closed meanwhile, or before.
    public bool TryLeave() => Interlocked.CompareExchange(ref _state, Open, Inside) == Inside;

    // As TryLeave, for one whose own end nobody awaits.
    public void Leave()
    {
        if (!TryLeave())
            _closed.TrySetResult(true);
    }

    // In place of Leave, where a delivery threw: the one who awaits the end gets the exception, and nobody enters any more.
    public void Fail(Exception exception)
    {
        Interlocked.Exchange(ref _state, Closed);
        _closed.TrySetException(exception);
    }

    public void Close()
    {
        if (Interlocked.Exchange(ref _state, Closed) == Open)
            _closed.TrySetResult(true);
    }

    // Ends as the deliveries do, or when the gate is closed and nobody is inside, or with the exception of Fail.
    public async Task UntilClosedAsync(Task deliveries)
    {
        if (await Task.WhenAny(deliveries, _closed.Task).ConfigureAwait(false) == deliveries)
        {
            await deliveries.ConfigureAwait(false);
            return;
        }

        _ = deliveries.ContinueWith(static task => _ = task.Exception, TaskContinuationOptions.OnlyOnFaulted);
        await _closed.Task.ConfigureAwait(false);
        throw new OperationCanceledException();
    }

    private bool WaitToEnter()
    {
        var wait = default(SpinWait);
        while (true)
        {
            wait.SpinOnce();
            int state = Interlocked.CompareExchange(ref _state, Inside, Open);
            if (state != Inside)
                return state == Open;
        }
    }
}
