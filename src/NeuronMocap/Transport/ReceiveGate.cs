namespace NeuronMocap.Transport;

// Guards the deliveries of a link if pool threads deliver. One thread at a time can enter, and none after the end. A closed link is therefore finished as
// soon as no thread is inside, which the closing thread checks here. It does not wait for the system to complete an operation on a pool thread, which may
// not be free for a while.
internal sealed class ReceiveGate
{
    private const int Open = 0;
    private const int Inside = 1;
    private const int Closed = 2;

    // Code that awaits this task continues on the thread that closes the gate.
    private readonly TaskCompletionSource<bool> _closed = new();
    private int _state;

    // Whether a delivery is running, or ended with an exception.
    public bool IsInside => Volatile.Read(ref _state) == Inside;

    // Called before a delivery. Returns false at the end. It may have to wait for a timer that delivers held datagrams; this is rare, but lasts as long as
    // the handlers. During this wait the thread checks about once in a millisecond and receives nothing, the same as while it runs a slow handler itself.
    public bool TryEnter()
    {
        int state = Interlocked.CompareExchange(ref _state, Inside, Open);
        return state == Open || (state == Inside && WaitToEnter());
    }

    // Does the same as TryEnter, but also returns false while another thread is inside.
    public bool TryEnterIdle() => Interlocked.CompareExchange(ref _state, Inside, Open) == Open;

    // Called after a delivery. Returns false if the gate was closed in the meantime, or before.
    public bool TryLeave() => Interlocked.CompareExchange(ref _state, Open, Inside) == Inside;

    // Does the same as TryLeave, for a thread whose own end is not awaited.
    public void Leave()
    {
        if (!TryLeave())
            _closed.TrySetResult(true);
    }

    // Replaces Leave if a delivery threw. The code that awaits the end gets the exception, and no thread can enter again.
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

    // Ends when the deliveries end, when the gate is closed and no thread is inside, or with the exception of Fail.
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
