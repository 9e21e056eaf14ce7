namespace NeuronMocap.Delivery;

// A queue that can be awaited, for the asynchronous enumerations. It returns copies of frames, because code that awaits keeps them.
internal sealed class FrameStream : IDisposable
{
    private readonly FrameQueue _queue;

    // Never disposed: it holds no handle, and the receive thread may release it after the end.
    private readonly SemaphoreSlim _signal = new(0);
    private readonly Queue<AvatarFrame> _taken = new();
    private readonly Action<AvatarFrame> _take;
    private int _waiting;

    // Called before the queue gets its first frame.
    public FrameStream(FrameQueue queue)
    {
        _queue = queue;
        _queue.Changed = Wake;
        _take = frame => _taken.Enqueue(frame.Clone());
    }

    public void Dispose() => _queue.Dispose();

    // Returns a copy of a waiting frame; null if no frame waits.
    public AvatarFrame? TryRead()
    {
        if (_taken.Count == 0)
            _queue.Pump(_take, maxFrames: 16);

        return _taken.TryDequeue(out AvatarFrame? frame) ? frame : null;
    }

    // Returns null at the end.
    public ValueTask<AvatarFrame?> ReadAsync(CancellationToken cancellationToken) => TryRead() is { } frame ? new(frame) : WaitAsync(cancellationToken);

    private async ValueTask<AvatarFrame?> WaitAsync(CancellationToken cancellationToken)
    {
        while (true)
        {
            bool isComplete = _queue.IsAddingCompleted;
            if (TryRead() is { } frame)
                return frame;
            if (isComplete)
                return null;

            // Announce the wait, then check again: a packet that arrived before the announcement did not release the signal.
            Interlocked.Exchange(ref _waiting, 1);
            if (_queue.Count == 0 && !_queue.IsAddingCompleted)
                await _signal.WaitAsync(cancellationToken).ConfigureAwait(false);

            Interlocked.Exchange(ref _waiting, 0);
        }
    }

    private void Wake()
    {
        if (Interlocked.Exchange(ref _waiting, 0) == 1)
            _signal.Release();
    }
}
