namespace NeuronMocap.Transport;

// Waits for a task that never faults, without using a thread.
internal static class TaskWaiting
{
    // Cancellation ends only the wait.
    public static async Task WaitAsync(Task task, CancellationToken cancellationToken)
    {
        var cancelled = new TaskCompletionSource<bool>(TaskCreationOptions.RunContinuationsAsynchronously);
        using (cancellationToken.Register(() => cancelled.TrySetCanceled(cancellationToken)))
            await (await Task.WhenAny(task, cancelled.Task).ConfigureAwait(false)).ConfigureAwait(false);
    }

    public static async ValueTask WaitAsync(Task task, TimeSpan timeout)
    {
        using var delaySource = new CancellationTokenSource();
        await Task.WhenAny(task, Task.Delay(timeout, delaySource.Token)).ConfigureAwait(false);
        delaySource.Cancel();
    }
}
