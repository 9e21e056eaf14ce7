namespace NeuronMocap.Transport;

internal static class CancellableDelay
{
    // Completes after the time, or when cancelled. After a cancellation, the awaiting code continues on the cancelling thread; Task.Delay alone would use
    // a pool thread.
    public static async Task WaitAsync(TimeSpan time, CancellationToken cancellationToken)
    {
        var stopped = new TaskCompletionSource<bool>();
        using (cancellationToken.Register(() => stopped.TrySetResult(true)))
            await Task.WhenAny(stopped.Task, Task.Delay(time, cancellationToken)).ConfigureAwait(false);
    }
}
