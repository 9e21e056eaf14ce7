using System.Diagnostics;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>A background thread whose end can be awaited with a bound: before it was started, too, and from the thread itself.</summary>
internal sealed class Worker
{
    private readonly Thread _thread;

    public Worker(string name, Action body) => _thread = new Thread(() => body()) { IsBackground = true, Name = name };

    public string? Name => _thread.Name;

    public void Start() => _thread.Start();

    /// <summary>Waits for the end of the thread.</summary>
    /// <param name="deadline">Until when, in ticks of <see cref="Stopwatch"/>.</param>
    public void Join(long deadline)
    {
        if (_thread == Thread.CurrentThread || _thread.ThreadState.HasFlag(System.Threading.ThreadState.Unstarted))
            return;

        long remaining = (deadline - Stopwatch.GetTimestamp()) * 1000 / Stopwatch.Frequency;
        _thread.Join((int)Math.Max(0, remaining));
    }
}
