using System.Collections.Concurrent;
using UnityEngine.StandIn;

namespace UnityEngine;

/// <summary>Continues a script after an await on the main thread, in the next frame.</summary>
internal sealed class UnitySynchronizationContext : SynchronizationContext
{
    private readonly ConcurrentQueue<(SendOrPostCallback Callback, object? State)> _posted = new();

    public override void Post(SendOrPostCallback d, object? state) => _posted.Enqueue((d, state));

    public override void Send(SendOrPostCallback d, object? state)
    {
        if (!MainThread.IsCurrent)
            throw new NotSupportedException("Nothing of this stand-in waits for the main thread.");

        d(state);
    }

    public override SynchronizationContext CreateCopy() => this;

    internal void Run()
    {
        for (int count = _posted.Count; count > 0 && _posted.TryDequeue(out (SendOrPostCallback Callback, object? State) item); count--)
            Run(item.Callback, item.State);
    }

    // In its own method, so that the captured variables are allocated only when there is something to run, not in every frame.
    private static void Run(SendOrPostCallback callback, object? state) => ScriptCallbacks.Run(() => callback(state), null!);
}
