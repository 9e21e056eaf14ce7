namespace NeuronMocap.Tests.Infrastructure;

/// <summary>
/// Blocks all threads of the pool and keeps it from getting more, so that work that needs a pool thread stops. For tests that run alone.
/// </summary>
internal static class StarvedPool
{
    /// <summary>Runs the action on its own thread while the pool is starved.</summary>
    public static Task RunAsync(Action action) => Task.Factory.StartNew(() => Run(action), TaskCreationOptions.LongRunning);

    private static void Run(Action action)
    {
        using var free = new ManualResetEvent(initialState: false);
        using var left = new CountdownEvent(1);
        ThreadPool.GetMaxThreads(out int workers, out int completers);
        ThreadPool.GetMinThreads(out int fewestWorkers, out int fewestCompleters);
        Assert.True(ThreadPool.SetMinThreads(1, fewestCompleters));
        Assert.True(ThreadPool.SetMaxThreads(Environment.ProcessorCount, completers));
        try
        {
            // Work that was queued before still runs. Then these take thread after thread, including threads that return from other work.
            do
                Block();
            while (HasFreeThread());
            for (int i = 0; i < Environment.ProcessorCount; i++)
                Block();

            action();
        }
        finally
        {
            ThreadPool.SetMaxThreads(workers, completers);
            ThreadPool.SetMinThreads(fewestWorkers, fewestCompleters);
            free.Set();
            left.Signal();
            left.Wait();
        }

        void Block()
        {
            left.AddCount();
            ThreadPool.QueueUserWorkItem(_ =>
            {
                free.WaitOne();
                left.Signal();
            });
        }
    }

    private static bool HasFreeThread()
    {
        var ran = new ManualResetEventSlim();
        ThreadPool.QueueUserWorkItem(_ => ran.Set());
        return ran.Wait(TimeSpan.FromMilliseconds(100));
    }
}
