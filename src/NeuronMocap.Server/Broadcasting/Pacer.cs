namespace NeuronMocap.Server.Broadcasting;

/// <summary>Publishes frames when they are due, on its own thread.</summary>
internal abstract class Pacer
{
    private readonly Action<Exception?> _ended;

    /// <summary>Creates a pacer.</summary>
    /// <param name="ended">Called once on the pacer's thread: after the last frame, after a stop, or with the exception that a source threw.</param>
    /// <param name="report">Receives the exceptions that <paramref name="ended"/> throws.</param>
    protected Pacer(Action<Exception?> ended, FaultReport report)
    {
        _ended = ended;
        Worker = new Worker("NeuronMocap pacer", Run, report);
    }

    public Worker Worker { get; }

    // Pulsed when the broadcast is stopped.
    protected object Lock { get; } = new();

    // Read and written under the gate.
    protected bool IsStopping { get; private set; }

    // Called once, before the thread starts.
    public virtual void Open()
    {
    }

    public virtual void Stop()
    {
        lock (Lock)
        {
            IsStopping = true;
            Monitor.PulseAll(Lock);
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
