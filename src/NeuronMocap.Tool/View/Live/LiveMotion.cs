namespace NeuronMocap.Tool.View.Live;

/// <summary>The motion of the source for those who need it now. While nobody does, no frame is taken from the reader. Thread-safe.</summary>
/// <param name="reader">The reader, which its owner disposes later.</param>
internal sealed class LiveMotion(NeuronReader reader) : IDisposable
{
    private readonly Lock _lock = new();
    private Action<AvatarFrame>[] _handlers = [];
    private FrameQueue? _queue;
    private Task _pump = Task.CompletedTask;
    private long _taken;
    private bool _isDisposed;

    /// <summary>Number of frames that were taken from the reader.</summary>
    public long FramesTaken => Interlocked.Read(ref _taken);

    /// <summary>Calls a handler for every frame, until the result is disposed.</summary>
    /// <param name="handler">
    /// Called on a pool thread, one call at a time for all handlers. The frame is valid during the call. A slow handler makes all of them lose old frames.
    /// </param>
    public IDisposable Subscribe(Action<AvatarFrame> handler)
    {
        lock (_lock)
        {
            _handlers = [.. _handlers, handler];
            if (_queue is null && !_isDisposed)
                Open();
        }

        return new Subscription(this, handler);
    }

    public void Dispose()
    {
        lock (_lock)
        {
            _isDisposed = true;
            _queue?.Dispose();
            _queue = null;
        }
    }

    private void Open()
    {
        try
        {
            _queue = reader.OpenQueue(new FrameQueueOptions { Name = "view", WhenFull = WhenFull.DropOldest });
            _pump = PumpAsync(_queue, _pump);
        }
        catch (ObjectDisposedException)
        {
            // The stream has ended.
        }
    }

    // Waits for the handler that may still work on a frame of the previous queue.
    private async Task PumpAsync(FrameQueue queue, Task previous)
    {
        await previous.ConfigureAwait(false);
        while (await queue.WaitAsync().ConfigureAwait(false))
            queue.Pump<AvatarFrame>(Deliver);
    }

    private void Deliver(AvatarFrame frame)
    {
        Interlocked.Increment(ref _taken);
        foreach (Action<AvatarFrame> handler in Volatile.Read(ref _handlers))
            handler(frame);
    }

    private void Remove(Action<AvatarFrame> handler)
    {
        lock (_lock)
        {
            int index = Array.IndexOf(_handlers, handler);
            if (index < 0)
                return;

            _handlers = [.. _handlers[..index], .. _handlers[(index + 1)..]];
            if (_handlers.Length > 0)
                return;

            _queue?.Dispose();
            _queue = null;
        }
    }

    private sealed class Subscription(LiveMotion motion, Action<AvatarFrame> handler) : IDisposable
    {
        private int _isDisposed;

        public void Dispose()
        {
            if (Interlocked.Exchange(ref _isDisposed, 1) == 0)
                motion.Remove(handler);
        }
    }
}
