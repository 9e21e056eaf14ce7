namespace NeuronMocap.Delivery;

// The way to a window's thread: a context or a function of the application. One post at a time is outstanding. Calls of Post can still overlap: the window
// can run a post, and need the next, before the call that posted it returns.
internal sealed class ContextPoster
{
    [ThreadStatic]
    private static ContextPoster? _posting;

    private readonly SynchronizationContext? _context;
    private readonly Func<Action, bool>? _post;
    private readonly SendOrPostCallback _callback;
    private readonly Action _run;
    private volatile Thread? _thread;
    private volatile bool _ranAtOnce;

    // thread: the context's thread, if it is known before the first run.
    private ContextPoster(SynchronizationContext? context, Func<Action, bool>? post, Thread? thread, Action run)
    {
        _context = context;
        _post = post;
        _thread = thread;
        _run = () => OnRun(run);
        _callback = _ => OnRun(run);
    }

    // Whether the thread of the context has ended. A thread of the pool may end while its context lives, so it is not remembered.
    public bool HasThreadEnded => _thread is { IsAlive: false };

    public static ContextPoster Create(SynchronizationContext? context, Func<Action, bool>? post, Action run)
    {
        if (post is not null)
            return new ContextPoster(context: null, post, thread: null, run);

        SynchronizationContext? current = SynchronizationContext.Current;
        context ??= current ?? throw new InvalidOperationException(
            "This thread has no SynchronizationContext. Open the delivery on the window's thread after the window is made, or set Context or Post of its "
            + "options.");
        return new ContextPoster(context, post: null, ReferenceEquals(context, current) ? OwnThread() : null, run);
    }

    // Returns null if the post was taken, or else the reason why the delivery ends.
    public FrameDeliveryEnd? Post()
    {
        ContextPoster? outer = _posting;
        _posting = this;
        try
        {
            if (_post is not null)
            {
                if (!_post(_run))
                    return new FrameDeliveryEnd(FrameDeliveryEndReason.ContextGone, "The window is gone: Post returned false.");
            }
            else
            {
                _context!.Post(_callback, state: null);
            }
        }
        catch (Exception exception)
        {
            // For example InvalidOperationException, InvalidAsynchronousStateException or ObjectDisposedException of Windows Forms.
            return new FrameDeliveryEnd(
                FrameDeliveryEndReason.ContextGone, $"The window is gone: its context threw {exception.GetType()} for a post. {exception.Message}", exception);
        }
        finally
        {
            _posting = outer;
        }

        return _ranAtOnce
            ? new FrameDeliveryEnd(
                FrameDeliveryEndReason.NotPosted,
                "The context ran a post at once instead of posting it, so the handlers would not run on the window's thread.")
            : null;
    }

    private static Thread? OwnThread() => Thread.CurrentThread is { IsThreadPoolThread: false } thread ? thread : null;

    // A run inside a call of Post, on the same thread, is not a post.
    private void OnRun(Action run)
    {
        if (ReferenceEquals(_posting, this))
        {
            _ranAtOnce = true;
            return;
        }

        _thread = OwnThread();
        run();
    }
}
