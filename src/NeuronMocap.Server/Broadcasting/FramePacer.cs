using System.Diagnostics;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>Encodes the frames at their times and publishes them, on a thread of its own.</summary>
internal sealed class FramePacer
{
    private readonly FramePlan _plan;
    private readonly double _rate;
    private readonly FrameLog _log;
    private readonly Action<Exception?> _ended;
    private readonly object _gate = new();
    private bool _isStopping;

    /// <summary>Makes a pacer.</summary>
    /// <param name="plan">What to encode.</param>
    /// <param name="rate">Frames per second.</param>
    /// <param name="log">Where to publish.</param>
    /// <param name="ended">Called once on the pacer's thread, after the last frame, after a stop, or with what a source threw.</param>
    public FramePacer(FramePlan plan, double rate, FrameLog log, Action<Exception?> ended)
    {
        _plan = plan;
        _rate = rate;
        _log = log;
        _ended = ended;
        Worker = new Worker("NeuronMocap pacer", Run);
    }

    public Worker Worker { get; }

    public void Stop()
    {
        lock (_gate)
        {
            _isStopping = true;
            Monitor.PulseAll(_gate);
        }
    }

    private void Run()
    {
        Exception? error = null;
        try
        {
            PublishAll();
        }
        catch (Exception exception)
        {
            error = exception;
        }

        _ended(error);
    }

    private void PublishAll()
    {
        var clock = new FrameClock(_rate, Stopwatch.GetTimestamp());
        FrameEncoder encoder = _plan.CreateEncoder();
        byte[] bytes = new byte[_plan.MaxFrameSize];
        for (long frame = 0; frame < _plan.FrameCount; frame++)
        {
            // Encoded before its time comes, so that the work delays nothing.
            int length = encoder.Encode(frame, bytes);
            if (!WaitFor(frame, clock))
                return;

            _log.Publish(bytes.AsSpan(0, length));
        }
    }

    // False when the broadcast is stopped first.
    private bool WaitFor(long frame, FrameClock clock)
    {
        lock (_gate)
        {
            int delay;
            while (!_isStopping && (delay = clock.GetDelay(frame, Stopwatch.GetTimestamp())) > 0)
                Monitor.Wait(_gate, delay);

            return !_isStopping;
        }
    }
}
