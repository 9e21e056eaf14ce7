using System.Diagnostics;

namespace NeuronMocap.Recording;

// Connects the callers that control a playback with its thread: it decides what is played next, and when. Any thread may call it; only the
// playback's thread waits here.
internal sealed class PlaybackControl(PlaybackTime time, TimeSpan duration)
{
    public const int Endless = int.MaxValue;

    private readonly object _lock = new();
    private readonly PlaybackClock _clock = new(catchesUp: time is ManualTime);
    private TimeSpan? _seek;
    private int _steps;
    private int _stepsBack;

    // During a step back: the position was found, and a step forward must show the frame.
    private bool _isShowing;
    private int _passes = 1;
    private int _pass = 1;
    private bool _isPaused;
    private volatile bool _hasEnded;

    // Whether a link plays, and when the event is due for which it waits.
    private bool _isPlaying;
    private long _awaited;

    public TimeSpan Position
    {
        get
        {
            lock (_lock)
            {
                TimeSpan position = _seek ?? _clock.PositionAt(time.Now);
                return position < duration ? position : duration;
            }
        }
    }

    public double Speed
    {
        get
        {
            lock (_lock)
                return _clock.Speed;
        }

        set => Change(() => _clock.SetSpeed(value, time.Now));
    }

    public int Passes
    {
        get
        {
            lock (_lock)
                return _passes;
        }

        set => Change(() => _passes = value);
    }

    public int Pass
    {
        get
        {
            lock (_lock)
                return _pass;
        }
    }

    public bool IsPaused
    {
        get
        {
            lock (_lock)
                return _isPaused;
        }
    }

    public void Pause() => Change(Halt);

    public void Resume() => Change(() => _isPaused = false);

    public void Step() => Change(() =>
    {
        Halt();
        if (_stepsBack > 0)
            _stepsBack--;
        else
            _steps++;
    });

    public void StepBack() => Change(() =>
    {
        Halt();
        if (_steps > 1 && _isShowing)
            _steps--;
        else
            _stepsBack++;
    });

    public void Seek(TimeSpan target) => Change(() =>
    {
        _seek = target;
        (_steps, _stepsBack, _isShowing) = (0, 0, false);
    });

    // Any thread. Whether the playback has ended.
    public bool HasEnded => _hasEnded;

    // Called when a manual clock has moved.
    public void FollowClock()
    {
        lock (_lock)
        {
            if (_awaited <= time.Now)
                Monitor.PulseAll(_lock);
        }
    }

    // Any thread except the playback's.
    public bool WaitUntilDelivered(TimeSpan timeout)
    {
        long end = timeout == Timeout.InfiniteTimeSpan ? long.MaxValue : RecordedTime.Add(Stopwatch.GetTimestamp(), RecordedTime.ToTimestamp(timeout));
        lock (_lock)
        {
            while (_isPlaying && !_isPaused && !_hasEnded && _clock.IsPaced && _awaited <= time.Now)
            {
                double rest = (end - Stopwatch.GetTimestamp()) * 1000.0 / Stopwatch.Frequency;
                if (rest <= 0)
                    return false;

                Monitor.Wait(_lock, (int)Math.Ceiling(Math.Min(rest, int.MaxValue / 2)));
            }

            return true;
        }
    }

    // Playback thread. No further link follows.
    public void Leave()
    {
        lock (_lock)
        {
            _isPlaying = false;
            Monitor.PulseAll(_lock);
        }
    }

    // Called when a link was closed.
    public void Wake() => Change(static () => { });

    public void End() => Change(() => _hasEnded = true);

    // Playback thread. Waits until the next action is known. The timestamp is the time when the event was due.
    public PlaybackAction WaitFor(TimeSpan instant, CancellationToken cancellationToken, out long timestamp)
    {
        timestamp = 0;
        lock (_lock)
        {
            _isPlaying = true;
            while (true)
            {
                if (cancellationToken.IsCancellationRequested || _hasEnded)
                    return PlaybackAction.Stop;
                if (_seek is not null)
                    return PlaybackAction.Seek;
                if (_stepsBack > 0 && (_steps == 0 || _isShowing))
                    return PlaybackAction.StepBack;
                if (_steps > 0)
                    return PlaybackAction.Step;

                if (_isPaused)
                {
                    Monitor.Wait(_lock);
                    continue;
                }

                long now = time.Now;
                if (!_clock.IsRunning)
                    _clock.Run(now);
                if (_clock.IsPaced && _clock.DueAt(instant) is var due && due > now)
                {
                    _awaited = due;
                    Monitor.PulseAll(_lock);
                    time.Wait(_lock, due);
                    continue;
                }

                timestamp = _clock.Reach(instant, now);
                return PlaybackAction.Play;
            }
        }
    }

    // Playback thread. Returns the position that a seek requested.
    public TimeSpan TakeSeek()
    {
        lock (_lock)
        {
            TimeSpan target = _seek ?? TimeSpan.Zero;
            _seek = null;
            _clock.MoveTo(target, time.Now);
            return target;
        }
    }

    // Playback thread. Returns how many frames to go back from the last frame passed. A step forward, which shows the frame, replaces the steps
    // back. A frame that is still to be shown does not count as passed.
    public int TakeStepsBack()
    {
        lock (_lock)
        {
            int count = _stepsBack - (_isShowing ? 1 : 0);
            (_steps, _stepsBack, _isShowing) = (1, 0, true);
            return count;
        }
    }

    // Playback thread. A step has reached a position, whose bytes are due now.
    public long StepTo(TimeSpan place)
    {
        lock (_lock)
        {
            long now = time.Now;
            _clock.MoveTo(place, now);
            return _clock.Reach(place, now);
        }
    }

    // Playback thread. A frame was delivered, or there is none.
    public void EndStep()
    {
        lock (_lock)
        {
            _steps = Math.Max(0, _steps - 1);
            _isShowing = false;
        }
    }

    // Playback thread, at the end of a pass. Returns whether another pass follows. The next pass begins at the instant at which this one ends.
    public bool BeginPass()
    {
        lock (_lock)
        {
            if (_passes != Endless && _pass >= _passes)
                return false;

            _pass += _pass < Endless ? 1 : 0;
            _clock.MoveTo(TimeSpan.Zero, _clock.IsPaced ? _clock.DueAt(duration) : time.Now);
            return true;
        }
    }

    // Called with the lock held.
    private void Halt()
    {
        if (!_isPaused)
            _clock.Halt(time.Now);

        _isPaused = true;
    }

    private void Change(Action change)
    {
        lock (_lock)
        {
            change();
            _awaited = long.MinValue;
            Monitor.PulseAll(_lock);
        }
    }
}
