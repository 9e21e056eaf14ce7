namespace NeuronMocap.RabbitMq.Connecting;

// Waits for a limited time, and leaves tasks alone that do not end.
internal static class TaskAbandoning
{
    // Completes when the task, the time or the token ends. It does not throw.
    public static async Task WaitAsync(Task task, TimeSpan timeout, CancellationToken cancellationToken)
    {
        using var delaySource = CancellationTokenSource.CreateLinkedTokenSource(cancellationToken);
        await Task.WhenAny(task, Task.Delay(timeout, delaySource.Token)).ConfigureAwait(false);
        delaySource.Cancel();
    }

    // Disposes of a result that comes too late, and observes a failure.
    public static void Abandon<T>(Task<T> task, Action<T> dispose) => _ = task.ContinueWith(
        late =>
        {
            if (late.Exception is null && !late.IsCanceled)
                dispose(late.Result);
        },
        CancellationToken.None,
        TaskContinuationOptions.None,
        TaskScheduler.Default);
}
