namespace NeuronMocap.Server.Broadcasting;

/// <summary>Publishes frames at their times, on a thread of its own.</summary>
internal abstract class Pacer
{
    private readonly Action<Exception?> _ended;

    /// <summary>Makes a pacer.</summary>
    /// <param name="ended">Called once on the pacer's thread, after the last frame, after a stop, or with what a source threw.</param>
    /// <param name="report">Told what the end itself throws.</param>
    protected Pacer(Action<Exception?> ended, FaultReport report)
    {
        _ended = ended;
        Worker = new Worker("NeuronMocap pacer", Run, report);
    }

    public Worker Worker { get; }

    // Pulsed when the broadcast is stopped.
    protected object Gate { get; } = new();

    // Under the gate.
    protected bool IsStopping { get; private set; }

    public void Stop()
    {
        lock (Gate)
        {
            IsStopping = true;
            Monitor.PulseAll(Gate);
        }
    }

    protected abstract void PublishAll();

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
}
