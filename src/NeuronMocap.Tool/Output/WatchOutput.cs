using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Output;

/// <summary>A format for arriving frames. Each format overrides only the methods that it needs.</summary>
internal abstract class WatchOutput
{
    /// <summary>Why the output could not be written. Null if it was written, or if its reader closed it.</summary>
    public IOException? Failure { get; private set; }

    /// <summary>Called on the receive thread for every frame. The frame is valid during the call, and the connection waits for it.</summary>
    public virtual void OnMotion(MotionFrame frame)
    {
    }

    /// <summary>Called like <see cref="OnMotion"/>.</summary>
    public virtual void OnCalculation(CalculationFrame frame)
    {
    }

    /// <summary>Called like <see cref="OnMotion"/>.</summary>
    public virtual void OnStudioCalculation(StudioCalculationFrame frame)
    {
    }

    /// <summary>Called on any thread, one call at a time.</summary>
    public virtual void OnStatus(ConnectionStatus status)
    {
    }

    /// <summary>Called on any thread when a recording or an export has ended because its file cannot be written any more.</summary>
    /// <returns>Whether the output shows the failure.</returns>
    public virtual bool OnFileFailed(FileFailure failure) => false;

    /// <summary>Runs until it is stopped, or until the user or the reader of the output ends it.</summary>
    public virtual Task RunAsync(CancellationToken cancellationToken) => Until(cancellationToken);

    /// <summary>Called once at the end, when nothing more arrives.</summary>
    public abstract void Finish(ReaderStatistics statistics);

    /// <summary>
    /// Keeps the reason for the end of the run. A closed pipe is not a failure: `neuron-mocap watch --json | head -1` closes it on purpose.
    /// </summary>
    protected void OnWriteFailed(IOException exception)
    {
        if (!StandardStreams.IsBrokenPipe(exception))
            Failure ??= exception;
    }

    protected static async Task Until(CancellationToken cancellationToken) =>
        await Task.Delay(Timeout.Infinite, cancellationToken).ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
}
