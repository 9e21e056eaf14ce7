namespace NeuronMocap.Delivery;

// The frames of a queue for the asynchronous enumerations. It returns copies of frames, because code that awaits keeps them.
internal sealed class FrameStream : IDisposable
{
    private readonly FrameQueue _queue;
    private readonly Queue<AvatarFrame> _taken = new();
    private readonly Action<AvatarFrame> _take;

    // Called before the queue gets its first frame.
    public FrameStream(FrameQueue queue)
    {
        _queue = queue;
        _queue.PrepareWaiting();
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

    // Returns null at the end. A cancelled loop gets no more frames, even if some wait: a slow loop would never end.
    public ValueTask<AvatarFrame?> ReadAsync(CancellationToken cancellationToken)
    {
        if (cancellationToken.IsCancellationRequested)
            return new ValueTask<AvatarFrame?>(Task.FromCanceled<AvatarFrame?>(cancellationToken));

        return TryRead() is { } frame ? new(frame) : WaitAsync(cancellationToken);
    }

    private async ValueTask<AvatarFrame?> WaitAsync(CancellationToken cancellationToken)
    {
        while (await _queue.WaitAsync(cancellationToken).ConfigureAwait(false))
        {
            if (TryRead() is { } frame)
                return frame;
        }

        return null;
    }
}
