using System.Runtime.CompilerServices;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>Waits for things that happen at once unless there is a fault.</summary>
internal static class Limits
{
    // Far longer than any usual wait, so that only a failure reaches it.
    public static readonly TimeSpan Unexpected = TimeSpan.FromSeconds(60);

    // The pool creates new threads slowly, so tests that block some threads would delay all others for seconds.
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

    // The minimum of some attempts. A busy machine delays single attempts. A wait for a time-out is slow in every attempt.
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

    // For work that another thread is about to do, if there is no event to wait for.
    public static async Task UntilAsync(Func<bool> condition)
    {
        using var limit = CancellationTokenSource.CreateLinkedTokenSource(TestContext.Current.CancellationToken);
        limit.CancelAfter(Unexpected);
        while (!condition())
            await Task.Delay(1, limit.Token);
    }
}
