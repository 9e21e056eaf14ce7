namespace NeuronMocap.Tests.Delivery;

/// <summary>What a message loop does with posts after its end.</summary>
internal enum LatePost
{
    Throw,
    Ignore,
}

/// <summary>A thread with a message loop and a context, like the thread of a window.</summary>
internal sealed class MessageLoop : SynchronizationContext, IDisposable
{
    private readonly object _lock = new();
    private readonly Queue<(SendOrPostCallback Callback, object? State)> _messages = new();
    private readonly List<Exception> _exceptions = [];
    private readonly LatePost _latePost;
    private readonly ManualResetEventSlim _mayEndThread = new(initialState: true);
    private int _outstanding;
    private bool _hasEnded;

    public MessageLoop(LatePost latePost = LatePost.Throw)
    {
        _latePost = latePost;
        Thread = new Thread(Run) { IsBackground = true, Name = "message loop" };
        Thread.Start();
    }

    public Thread Thread { get; }

    public bool IsCurrent => Thread.CurrentThread == Thread;

    public int Posts { get; private set; }

    /// <summary>Largest number of messages that waited at the same time, not counting those of <see cref="Invoke{T}"/>.</summary>
    public int MostOutstanding { get; private set; }

    /// <summary>Exceptions that left a message; the loop continues after them.</summary>
    public IReadOnlyList<Exception> Exceptions
    {
        get
        {
            lock (_lock)
                return [.. _exceptions];
        }
    }

    public override void Post(SendOrPostCallback d, object? state)
    {
        lock (_lock)
        {
            if (_hasEnded && _latePost == LatePost.Throw)
                throw new InvalidOperationException("The loop has ended.");
            if (_hasEnded)
                return;

            Posts++;
            MostOutstanding = Math.Max(MostOutstanding, ++_outstanding);
            _messages.Enqueue((argument =>
            {
                lock (_lock)
                    _outstanding--;

                d(argument);
            }, state));
            Monitor.PulseAll(_lock);
        }
    }

    public override void Send(SendOrPostCallback d, object? state) => throw new NotSupportedException("A delivery never sends.");

    /// <summary>Runs a function on the loop's thread and waits for it.</summary>
    public T Invoke<T>(Func<T> function)
    {
        var done = new TaskCompletionSource<T>(TaskCreationOptions.RunContinuationsAsynchronously);
        lock (_lock)
        {
            _messages.Enqueue((_ =>
            {
                try
                {
                    done.SetResult(function());
                }
                catch (Exception exception)
                {
                    done.SetException(exception);
                }
            }, null));
            Monitor.PulseAll(_lock);
        }

        Assert.True(((IAsyncResult)done.Task).AsyncWaitHandle.WaitOne(Limits.Unexpected), "The loop does not answer.");
        return done.Task.GetAwaiter().GetResult();
    }

    public void Invoke(Action action) => Invoke(() =>
    {
        action();
        return true;
    });

    /// <summary>Waits until the messages that wait now, and those that they post, have run.</summary>
    public void Drain()
    {
        do
        {
            Invoke(static () => { });
        }
        while (Count > 0);
    }

    /// <summary>Runs the messages that wait, from inside a message, as a modal dialog does.</summary>
    public void RunNested()
    {
        Assert.True(IsCurrent);
        while (TryTake(out (SendOrPostCallback Callback, object? State) message))
            message.Callback(message.State);
    }

    /// <summary>Ends the loop; messages that wait are lost. The thread ends too, unless <see cref="KeepThread"/> was called.</summary>
    public void End()
    {
        lock (_lock)
        {
            _hasEnded = true;
            _messages.Clear();
            Monitor.PulseAll(_lock);
        }

        if (!IsCurrent && _mayEndThread.IsSet)
            Assert.True(Thread.Join(Limits.Unexpected), "The loop does not end.");
    }

    /// <summary>Keeps the thread alive after the loop has ended, as when a program goes on after its window.</summary>
    public void KeepThread() => _mayEndThread.Reset();

    public void Dispose()
    {
        _mayEndThread.Set();
        End();
    }

    private int Count
    {
        get
        {
            lock (_lock)
                return _messages.Count;
        }
    }

    private void Run()
    {
        SetSynchronizationContext(this);
        while (WaitForMessage(out (SendOrPostCallback Callback, object? State) message))
        {
            try
            {
                message.Callback(message.State);
            }
            catch (Exception exception)
            {
                lock (_lock)
                    _exceptions.Add(exception);
            }
        }

        _mayEndThread.Wait(Limits.Unexpected);
    }

    private bool WaitForMessage(out (SendOrPostCallback Callback, object? State) message)
    {
        lock (_lock)
        {
            while (!_hasEnded && _messages.Count == 0)
                Monitor.Wait(_lock);

            message = _hasEnded ? default : _messages.Dequeue();
            return !_hasEnded;
        }
    }

    private bool TryTake(out (SendOrPostCallback Callback, object? State) message)
    {
        lock (_lock)
            return _messages.TryDequeue(out message);
    }
}
