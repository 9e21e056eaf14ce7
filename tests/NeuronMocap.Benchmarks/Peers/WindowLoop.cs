using System.Collections.Concurrent;
using System.Diagnostics;

namespace NeuronMocap.Benchmarks.Peers;

// A thread with a message loop, which measures how long posted messages wait and how long they run.
internal sealed class WindowLoop : SynchronizationContext, IDisposable
{
    private readonly BlockingCollection<(SendOrPostCallback Callback, object? State)> _messages = [];
    private readonly Thread _thread;
    private long _busy;

    public WindowLoop()
    {
        _thread = new Thread(Run) { IsBackground = true };
        _thread.Start();
    }

    // Time in messages of other threads so far, in ticks of Stopwatch.
    public long Busy => Volatile.Read(ref _busy);

    public override void Post(SendOrPostCallback d, object? state) => _messages.Add((d, state));

    // Returns the wait of a message in milliseconds.
    public async Task<double> ProbeAsync()
    {
        var done = new TaskCompletionSource<long>(TaskCreationOptions.RunContinuationsAsynchronously);
        long start = Stopwatch.GetTimestamp();
        _messages.Add((_ => done.SetResult(Stopwatch.GetTimestamp()), null));
        return Stopwatch.GetElapsedTime(start, await done.Task).TotalMilliseconds;
    }

    public void Dispose()
    {
        _messages.CompleteAdding();
        _thread.Join();
        _messages.Dispose();
    }

    private void Run()
    {
        SetSynchronizationContext(this);
        foreach ((SendOrPostCallback callback, object? state) in _messages.GetConsumingEnumerable())
        {
            long start = Stopwatch.GetTimestamp();
            callback(state);
            Volatile.Write(ref _busy, _busy + Stopwatch.GetTimestamp() - start);
        }
    }
}
