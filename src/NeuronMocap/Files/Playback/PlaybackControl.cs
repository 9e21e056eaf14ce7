namespace NeuronMocap.Recording;

// Where those who control a playback and its thread meet: what is played next, and when. Any thread; only the playback's ever waits here.
internal sealed class PlaybackControl(PlaybackTime time, TimeSpan duration)
{
    public const int Endless = int.MaxValue;

    private readonly object _lock = new();
    private readonly PlaybackClock _clock = new();
    private TimeSpan? _seek;
    private int _steps;
    private int _stepsBack;

    // Of steps back: the place was found, and a step forward shall show the frame.
    private bool _isShowing;
    private int _passes = 1;
    private int _pass = 1;
    private bool _isPaused;
    private volatile bool _hasEnded;

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

    // Any thread: nothing more is played.
    public bool HasEnded => _hasEnded;

    // A link was closed.
    public void Wake() => Change(static () => { });

    public void End() => Change(() => _hasEnded = true);

    // Playback thread: waits until it is known what to do next. Of what is due at the instant, timestamp is when it was.
    public PlaybackAction WaitFor(TimeSpan instant, CancellationToken cancellationToken, out long timestamp)
    {
        timestamp = 0;
        lock (_lock)
        {
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
                    time.Wait(_lock, due);
                    continue;
                }

                timestamp = _clock.Reach(instant, now);
                return PlaybackAction.Play;
            }
        }
    }

    // Playback thread: the place that a seek asked for.
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

    // Playback thread: frames to go back by, from the one that was passed last; a step forward, to show the frame, takes their place. The one that was
    // to be shown has not been passed.
    public int TakeStepsBack()
    {
        lock (_lock)
        {
            int count = _stepsBack - (_isShowing ? 1 : 0);
            (_steps, _stepsBack, _isShowing) = (1, 0, true);
            return count;
        }
    }

    // Playback thread: a step has come to a place, whose bytes are due now.
    public long StepTo(TimeSpan place)
    {
        lock (_lock)
        {
            long now = time.Now;
            _clock.MoveTo(place, now);
            return _clock.Reach(place, now);
        }
    }

    // Playback thread: a frame was handed out, or there is none.
    public void EndStep()
    {
        lock (_lock)
        {
            _steps = Math.Max(0, _steps - 1);
            _isShowing = false;
        }
    }

    // Playback thread, at the end of a pass: whether another follows. It begins at the very instant at which this one ends.
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

    // Under the gate.
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
            Monitor.PulseAll(_lock);
        }
    }
}
