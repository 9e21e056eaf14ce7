using System.Diagnostics;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>The threads of a server that may still run.</summary>
/// <remarks>
/// Includes threads whose work has ended: they run for a moment longer. Mono aborts a thread that runs at the end of the process, and can then crash.
/// Not thread-safe.
/// </remarks>
internal sealed class WorkerList
{
    private static readonly TimeSpan JoinTimeout = TimeSpan.FromSeconds(5);

    private readonly List<Worker> _workers = [];

    public void Add(Worker worker)
    {
        _workers.RemoveAll(static worker => worker.HasEnded);
        _workers.Add(worker);
    }

    /// <summary>Copies the list, for <see cref="Join"/> without a lock.</summary>
    /// <returns>A new array.</returns>
    public Worker[] ToArray() => [.. _workers];

    /// <summary>Waits for the end of all threads, for a limited time. The thread that calls this does not count.</summary>
    /// <param name="workers">The threads.</param>
    public static void Join(Worker[] workers)
    {
        long deadline = Stopwatch.GetTimestamp() + (long)(JoinTimeout.TotalSeconds * Stopwatch.Frequency);
        foreach (Worker worker in workers)
            worker.Join(deadline);
    }
}
