namespace NeuronMocap.Tool.Output;

/// <summary>A way of showing what arrives. What one does not need it leaves out.</summary>
internal abstract class WatchOutput
{
    /// <summary>Why the output could not be written, unless whoever read it has just left; null while it could.</summary>
    public IOException? Failure { get; private set; }

    /// <summary>Receive thread, for every frame; the frame is valid during the call, and the connection waits.</summary>
    public virtual void OnMotion(MotionFrame frame)
    {
    }

    /// <summary>As <see cref="OnMotion"/>.</summary>
    public virtual void OnCalculation(CalculationFrame frame)
    {
    }

    /// <summary>As <see cref="OnMotion"/>.</summary>
    public virtual void OnStudioCalculation(StudioCalculationFrame frame)
    {
    }

    /// <summary>Any thread, one call at a time.</summary>
    public virtual void OnStatus(ConnectionStatus status)
    {
    }

    /// <summary>A recording or an export has ended because its file cannot be written any more. Any thread.</summary>
    /// <returns>Whether it is shown.</returns>
    public virtual bool OnFileFailed(FileFailure failure) => false;

    /// <summary>Runs until it is stopped, or until whoever looks at the output has had enough.</summary>
    public virtual Task RunAsync(CancellationToken cancellationToken) => Until(cancellationToken);

    /// <summary>Called once at the end, when nothing more arrives.</summary>
    public abstract void Finish(ReaderStatistics statistics);

    /// <summary>Keeps the reason for the end of the run. A closed pipe is none: `neuron-mocap watch --json | head -1` has all it wanted.</summary>
    protected void OnWriteFailed(IOException exception)
    {
        if (!IsBrokenPipe(exception))
            Failure ??= exception;
    }

    /// <summary>Whether the output could not be written because whoever read it has left.</summary>
    public static bool IsBrokenPipe(IOException exception)
    {
        const int BrokenPipe = 32;
        return exception.HResult == BrokenPipe;
    }

    protected static async Task Until(CancellationToken cancellationToken) =>
        await Task.Delay(Timeout.Infinite, cancellationToken).ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
}
