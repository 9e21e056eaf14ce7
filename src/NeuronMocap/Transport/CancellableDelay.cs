namespace NeuronMocap.Transport;

internal static class CancellableDelay
{
    // Completes after the time, or when cancelled: then what awaits it goes on on the thread that stops, where Task.Delay alone takes one of the pool's.
    public static async Task WaitAsync(TimeSpan time, CancellationToken cancellationToken)
    {
        var stopped = new TaskCompletionSource<bool>();
        using (cancellationToken.Register(() => stopped.TrySetResult(true)))
            await Task.WhenAny(stopped.Task, Task.Delay(time, cancellationToken)).ConfigureAwait(false);
    }
}
