namespace NeuronMocap.Transport;

internal static class CancellableDelay
{
    // Completes after the time, or with the stop: then what awaits it goes on on the thread that stops, where Task.Delay alone takes one of the pool's.
    public static async Task WaitAsync(TimeSpan time, CancellationToken stop)
    {
        var stopped = new TaskCompletionSource<bool>();
        using (stop.Register(() => stopped.TrySetResult(true)))
            await Task.WhenAny(stopped.Task, Task.Delay(time, stop)).ConfigureAwait(false);
    }
}
