using System.Runtime.InteropServices;

namespace NeuronMocap.Benchmarks.Peers;

// Keeps every processor awake until its standard input ends, with threads that Linux runs only when a processor has nothing else to do. The wake of an idle
// processor costs several times as much as a frame, and varies from second to second.
internal static class AwakeProcessors
{
    private const int IdlePolicy = 5;

    private static volatile bool _isOver;

    public static void Run()
    {
        using var begun = new CountdownEvent(Environment.ProcessorCount);
        Thread[] threads = [.. Enumerable.Range(0, begun.InitialCount).Select(_ => new Thread(() => Spin(begun)))];
        foreach (Thread thread in threads)
            thread.Start();

        // A peer prints its port. This one has none.
        begun.Wait();
        Console.WriteLine(0);
        Console.In.ReadToEnd();
        _isOver = true;
        foreach (Thread thread in threads)
            thread.Join();
    }

    // At any other priority, the loop would take time from what is measured.
    private static void Spin(CountdownEvent begun)
    {
        int priority = 0;
        if (!OperatingSystem.IsLinux() || SetScheduler(0, IdlePolicy, ref priority) != 0)
            throw new PlatformNotSupportedException("Only Linux has threads that run when a processor has nothing else to do.");

        begun.Signal();
        while (!_isOver)
            Thread.SpinWait(1000);
    }

    [DllImport("libc", EntryPoint = "sched_setscheduler")]
    private static extern int SetScheduler(int thread, int policy, ref int priority);
}
