using System.Diagnostics;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>
/// Preempts other threads in the middle of their work. Its threads sleep and then run for a fraction of a millisecond, because a system prefers a
/// waking thread to a running one. There are two threads for each processor. Half of them are above and half below the usual priority, if the system
/// honours that (Linux does not).
/// </summary>
internal sealed class Preemption : IDisposable
{
    private readonly Thread[] _threads;
    private volatile bool _isOver;

    public Preemption()
    {
        _threads = [.. Enumerable.Range(0, 2 * Environment.ProcessorCount).Select(CreateThread)];
        foreach (Thread thread in _threads)
            thread.Start();
    }

    /// <summary>Sometimes yields the processor or wastes a moment, so that threads meet at different places.</summary>
    public static void Stumble(Random random)
    {
        switch (random.Next(1_000))
        {
            case 0:
                Thread.Yield();
                break;
            case 1:
                Thread.Sleep(0);
                break;
            case < 50:
                Thread.SpinWait(random.Next(300));
                break;
        }
    }

    public void Dispose()
    {
        _isOver = true;
        foreach (Thread thread in _threads)
            thread.Join();
    }

    private Thread CreateThread(int index) => new(Run)
    {
        IsBackground = true,
        Priority = index % 2 == 0 ? ThreadPriority.BelowNormal : ThreadPriority.AboveNormal,
    };

    private void Run()
    {
        var random = new Random();
        while (!_isOver)
        {
            long start = Stopwatch.GetTimestamp();
            TimeSpan length = TimeSpan.FromMicroseconds(random.Next(20, 500));
            while (Stopwatch.GetElapsedTime(start) < length)
                Thread.SpinWait(20);

            Thread.Sleep(1);
        }
    }
}
