namespace NeuronMocap.Tests.Delivery;

/// <summary>A context whose posts run when a test runs them, on the test's own thread. Allocates nothing for a post.</summary>
internal sealed class ManualContext : SynchronizationContext
{
    private readonly object _lock = new();
    private readonly Queue<(SendOrPostCallback Callback, object? State)> _waiting = new(16);

    public int Waiting
    {
        get
        {
            lock (_lock)
                return _waiting.Count;
        }
    }

    public int MostWaiting { get; private set; }

    public int Posts { get; private set; }

    /// <summary>Called for each post, before it is taken.</summary>
    public Action? Posting { get; set; }

    public override void Post(SendOrPostCallback d, object? state)
    {
        Posts++;
        Posting?.Invoke();
        lock (_lock)
        {
            _waiting.Enqueue((d, state));
            MostWaiting = Math.Max(MostWaiting, _waiting.Count);
        }
    }

    public override void Send(SendOrPostCallback d, object? state) => throw new NotSupportedException("A delivery never sends.");

    /// <summary>Runs the oldest post.</summary>
    public void RunOne()
    {
        (SendOrPostCallback Callback, object? State) post;
        lock (_lock)
            post = _waiting.Dequeue();

        post.Callback(post.State);
    }

    /// <summary>Runs all posts, including those that arrive during the call, as Windows Forms does.</summary>
    public void RunAll()
    {
        while (Waiting > 0)
            RunOne();
    }
}
