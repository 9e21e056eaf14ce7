using System.Diagnostics;

namespace NeuronMocap.Delivery;

// Runs work on a window's thread with at most one post outstanding.
//
// The state has one owner. Whoever changes it from Idle or Waiting to Posted posts, and the run of that post owns it until the run changes it back. A
// producer stores its frame before it changes the state; the run changes the state to Idle before it looks for frames again. Both changes are interlocked
// and therefore full fences, so at least one side sees the other's work.
//
// A run lasts at most about MaxBusy. If work is left, the next run is posted at once until the runs together have taken that long. Then the runner waits,
// and another thread posts the next run. A post from the run itself would not do: Windows Forms runs posts that arrive during a post before any other
// message.
internal sealed class ContextRunner : IDisposable
{
    private const int Idle = 0;
    private const int Posted = 1;
    private const int Waiting = 2;
    private const int Closed = 3;

    // While a post is outstanding, every 64th request looks whether the context's thread is alive.
    private const int CheckMask = 63;

    private static readonly long MaxBusy = Stopwatch.Frequency * 4 / 1000;
    private static readonly long ShortestPause = Stopwatch.Frequency / 1000;
    private static readonly long LongestPause = Stopwatch.Frequency * 8 / 1000;

    // How long a post may wait after the thread has ended. The application may have moved its window to another thread.
    private static readonly long Grace = Stopwatch.Frequency * 2;

    private readonly ContextPoster _poster;
    private readonly DeliveryClock _clock;
    private readonly IContextWork _work;
    private int _state;
    private int _requests;
    private int _posts;
    private int _doubtedPost;
    private long _due;
    private long _busy;

    public ContextRunner(SynchronizationContext? context, Func<Action, bool>? post, DeliveryClock clock, IContextWork work)
    {
        _poster = ContextPoster.Create(context, post, Run);
        _work = work;
        _clock = clock;
        _clock.Elapsed = OnElapsed;
    }

    public bool HasThreadEnded => _poster.HasThreadEnded;

    // There is new work. Any thread. isUrgent: work that does not wait for the time that TryGetDue returned.
    public void Request(bool isUrgent = false)
    {
        int state = Interlocked.CompareExchange(ref _state, Posted, Idle);
        if (state == Idle)
            Post();
        else if (state == Waiting && (isUrgent || _clock.Now >= Volatile.Read(ref _due)))
            TryPostFromWaiting();
        else if (state == Posted && (++_requests & CheckMask) == 0)
            CheckThread();
    }

    // Any thread, also during a run. Nothing is posted any more.
    public void Dispose()
    {
        Interlocked.Exchange(ref _state, Closed);
        _clock.Dispose();
    }

    private bool TryPostFromWaiting()
    {
        if (Interlocked.CompareExchange(ref _state, Posted, Waiting) != Waiting)
            return false;

        Post();
        return true;
    }

    private void Post()
    {
        Volatile.Write(ref _posts, _posts + 1);
        if (_poster.Post() is { } end)
            _work.OnLost(end);
        else
            CheckThread();
    }

    // A loop that has ended can ignore posts without an error. Its dead thread is the only sign, and the timer confirms it.
    private void CheckThread()
    {
        int post = Volatile.Read(ref _posts);
        if (!_poster.HasThreadEnded || Interlocked.Exchange(ref _doubtedPost, post) == post)
            return;

        _clock.Set(Grace);
    }

    private void OnElapsed()
    {
        if (TryPostFromWaiting() || Volatile.Read(ref _state) != Posted || Volatile.Read(ref _doubtedPost) != Volatile.Read(ref _posts))
            return;

        if (_poster.HasThreadEnded)
            _work.OnLost(new FrameDeliveryEnd(FrameDeliveryEndReason.ContextGone, "The window is gone: its thread has ended."));
    }

    private void Run()
    {
        if (Volatile.Read(ref _state) == Closed)
            return;

        long start = _clock.Now;
        bool hasFailed = true;
        try
        {
            _work.Work(start + MaxBusy - _busy);
            hasFailed = false;
        }
        finally
        {
            _busy += _clock.Now - start;
            Continue(hasFailed);
        }
    }

    private void Continue(bool hasFailed)
    {
        bool hasWork = _work.TryGetDue(out long due);
        long now = _clock.Now;
        if (!hasWork && due <= now)
        {
            _busy = 0;
            if (Interlocked.CompareExchange(ref _state, Idle, Posted) == Posted && _work.TryGetDue(out _))
                Request();
            return;
        }

        if (hasFailed || _busy >= MaxBusy)
            due = Math.Max(due, now + Math.Min(Math.Max(_busy / 4, ShortestPause), LongestPause));

        if (due > now)
            Wait(due, now);
        else if (Volatile.Read(ref _state) == Posted)
            Post();
    }

    // The state comes first: a timer that elapsed before it would find nothing to do.
    private void Wait(long due, long now)
    {
        _busy = 0;
        Volatile.Write(ref _due, due);
        if (Interlocked.CompareExchange(ref _state, Waiting, Posted) == Posted)
            _clock.Set(due - now);
    }
}
