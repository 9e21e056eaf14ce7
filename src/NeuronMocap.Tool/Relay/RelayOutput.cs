using NeuronMocap.Tool.Output;

namespace NeuronMocap.Tool.Relay;

/// <summary>A format for the standard output of relay. No format makes the relay wait.</summary>
internal abstract class RelayOutput
{
    /// <summary>Why the output could not be written. Null if it was written, or if its reader closed it.</summary>
    public abstract IOException? Failure { get; }

    /// <summary>Writes where packets go, before the first one is received.</summary>
    public virtual void Announce()
    {
    }

    /// <summary>Called on any thread, one call at a time.</summary>
    public virtual void OnStatus(ConnectionStatus status)
    {
    }

    /// <summary>Called on any thread when a file cannot be written any more.</summary>
    /// <returns>Whether the output shows the failure.</returns>
    public abstract bool OnFileFailed(FileFailure failure);

    /// <summary>Reports until it is stopped. A closed output does not end the relay.</summary>
    public virtual async Task RunAsync(CancellationToken cancellationToken) =>
        await Task.Delay(Timeout.Infinite, cancellationToken).ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);

    /// <summary>Writes what was received and what went where. The destinations are finished.</summary>
    public abstract Task FinishAsync();

    /// <summary>Waits for the time of the next report. Returns false when the relay ends.</summary>
    protected static async Task<bool> WaitAsync(CancellationToken cancellationToken)
    {
        await Task.Delay(TimeSpan.FromSeconds(1), cancellationToken).ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
        return !cancellationToken.IsCancellationRequested;
    }
}
