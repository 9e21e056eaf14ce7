using System.Runtime.InteropServices;

namespace NeuronMocap.Benchmarks.Peers;

// Keeps every processor awake until its standard input ends, with threads that Linux runs only when a processor has nothing else to do. The wake of an idle
// processor costs a multiple of the work for one frame, and varies from second to second.
internal static class AwakeProcessors
{
    private const int IdlePolicy = 5;

    private static volatile bool _isOver;

    public static void Run()
    {
        Thread[] threads = [.. Enumerable.Range(0, Environment.ProcessorCount).Select(static _ => new Thread(Spin))];
        foreach (Thread thread in threads)
            thread.Start();

        // A peer prints its port. This one has none.
        Console.WriteLine(0);
        Console.In.ReadToEnd();
        _isOver = true;
        foreach (Thread thread in threads)
            thread.Join();
    }

    // At any other priority, the loop would take time from what is measured.
    private static void Spin()
    {
        int priority = 0;
        if (!OperatingSystem.IsLinux() || SetScheduler(0, IdlePolicy, ref priority) != 0)
            return;

        while (!_isOver)
            Thread.SpinWait(1000);
    }

    [DllImport("libc", EntryPoint = "sched_setscheduler")]
    private static extern int SetScheduler(int thread, int policy, ref int priority);
}
