using System.Runtime.CompilerServices;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>Waits for things that happen at once unless something is broken.</summary>
internal static class Limits
{
    // Far longer than anything ever takes, so that only a failure reaches it.
    public static readonly TimeSpan Unexpected = TimeSpan.FromSeconds(60);

    // The pool makes new threads slowly: tests that block some would hold up all others for seconds.
    [ModuleInitializer]
    internal static void SetMinThreads()
    {
        const int Enough = 64;
        ThreadPool.GetMinThreads(out _, out int completers);
        ThreadPool.SetMinThreads(Enough, completers);
    }

    public static Task Soon(this Task task) => task.WaitAsync(Unexpected, TestContext.Current.CancellationToken);

    public static Task<T> Soon<T>(this Task<T> task) => task.WaitAsync(Unexpected, TestContext.Current.CancellationToken);

    public static Task<T> Soon<T>(this ValueTask<T> task) => task.AsTask().Soon();

    // The least of some tries. A busy machine holds up single ones; what waits for a time-out in vain does so in each.
    public static async Task<TimeSpan> QuickestAsync(TimeSpan enough, Func<Task<TimeSpan>> attempt)
    {
        const int Tries = 20;
        TimeSpan quickest = TimeSpan.MaxValue;
        for (int i = 0; i < Tries && quickest > enough; i++)
        {
            TimeSpan time = await attempt();
            quickest = time < quickest ? time : quickest;
        }

        return quickest;
    }

    // For what another thread is about to do, where there is nothing to wait on.
    public static async Task UntilAsync(Func<bool> condition)
    {
        using var limit = CancellationTokenSource.CreateLinkedTokenSource(TestContext.Current.CancellationToken);
        limit.CancelAfter(Unexpected);
        while (!condition())
            await Task.Delay(1, limit.Token);
    }
}
