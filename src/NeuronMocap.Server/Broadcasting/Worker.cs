using System.Diagnostics;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>A background thread whose end can be awaited with a deadline. The wait also works before the start and on the thread itself.</summary>
/// <remarks>
/// Sources, providers and handlers are user code. An exception on the thread is reported and ends the thread, but never the process.
/// </remarks>
internal sealed class Worker
{
    private readonly Thread _thread;
    private readonly FaultReport _report;

    /// <summary>Creates a worker without starting it.</summary>
    /// <param name="name">Name of the thread.</param>
    /// <param name="body">The work. It cleans up even if it throws.</param>
    /// <param name="report">Receives the exceptions, on the thread.</param>
    public Worker(string name, Action body, FaultReport report)
    {
        _report = report;
        _thread = new Thread(() => Attempt(body)) { IsBackground = true, Name = name };
    }

    public string? Name => _thread.Name;

    public bool HasEnded => _thread.ThreadState.HasFlag(System.Threading.ThreadState.Stopped);

    public bool IsStarted => !_thread.ThreadState.HasFlag(System.Threading.ThreadState.Unstarted);

    public void Start() => _thread.Start();

    /// <summary>Runs a part of the work that may fail without ending the rest.</summary>
    /// <param name="part">The part.</param>
    /// <returns>False if the part threw an exception, which was reported.</returns>
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
    /// <param name="deadline">The end of the wait, in ticks of <see cref="Stopwatch"/>.</param>
    public void Join(long deadline)
    {
        if (_thread == Thread.CurrentThread || !IsStarted)
            return;

        long remaining = (deadline - Stopwatch.GetTimestamp()) * 1000 / Stopwatch.Frequency;
        _thread.Join((int)Math.Max(0, remaining));
    }
}
