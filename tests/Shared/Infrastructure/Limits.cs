namespace NeuronMocap.Tests.Infrastructure;

/// <summary>Waits for things that happen at once unless something is broken.</summary>
internal static class Limits
{
    // Far longer than anything ever takes, so that only a failure reaches it.
    public static readonly TimeSpan Unexpected = TimeSpan.FromSeconds(60);

    public static Task Soon(this Task task) => task.WaitAsync(Unexpected, TestContext.Current.CancellationToken);

    public static Task<T> Soon<T>(this Task<T> task) => task.WaitAsync(Unexpected, TestContext.Current.CancellationToken);

    public static Task<T> Soon<T>(this ValueTask<T> task) => task.AsTask().Soon();

    // For what another thread is about to do, where there is nothing to wait on.
    public static async Task UntilAsync(Func<bool> condition)
    {
        using var limit = CancellationTokenSource.CreateLinkedTokenSource(TestContext.Current.CancellationToken);
        limit.CancelAfter(Unexpected);
        while (!condition())
            await Task.Delay(1, limit.Token);
    }
}
