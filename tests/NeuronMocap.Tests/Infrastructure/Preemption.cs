using System.Diagnostics;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>
/// Takes the processors away from other threads in the middle of whatever they do: threads that sleep and then run for a fraction of a
/// millisecond, because a system prefers a thread that wakes to one that runs. Two for each processor, half of them above and half below the
/// usual priority where the system honours that (Linux does not).
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

    /// <summary>Now and then gives the processor away, or wastes a moment, so that threads meet at ever other places.</summary>
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
