using System.Diagnostics;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>
/// A background thread whose end can be awaited with a bound: before it was started, too, and from the thread itself. Whatever is thrown on it is
/// reported and ends the thread, never the process: sources, writers and handlers are the user's.
/// </summary>
internal sealed class Worker
{
    private readonly Thread _thread;
    private readonly FaultReport _report;

    /// <summary>Makes a worker that does nothing yet.</summary>
    /// <param name="name">Name of the thread.</param>
    /// <param name="body">What it does. Cleans up behind itself, also when something throws.</param>
    /// <param name="report">Told what was thrown, on the thread.</param>
    public Worker(string name, Action body, FaultReport report)
    {
        _report = report;
        _thread = new Thread(() => Attempt(body)) { IsBackground = true, Name = name };
    }

    public string? Name => _thread.Name;

    public bool IsStarted => !_thread.ThreadState.HasFlag(System.Threading.ThreadState.Unstarted);

    public void Start() => _thread.Start();

    /// <summary>Does a part of the work whose failure the rest survives.</summary>
    /// <param name="part">The part.</param>
    /// <returns>False when it threw, which was reported.</returns>
    public bool Attempt(Action part)
    {
        try
        {
            part();
            return true;
        }
        catch (Exception exception)
        {
            _report.Report(exception);
            return false;
        }
    }

    /// <summary>Waits for the end of the thread.</summary>
    /// <param name="deadline">Until when, in ticks of <see cref="Stopwatch"/>.</param>
    public void Join(long deadline)
    {
        if (_thread == Thread.CurrentThread || !IsStarted)
            return;

        long remaining = (deadline - Stopwatch.GetTimestamp()) * 1000 / Stopwatch.Frequency;
        _thread.Join((int)Math.Max(0, remaining));
    }
}
