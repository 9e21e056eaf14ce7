namespace NeuronMocap.Tool.Watch.Live;

/// <summary>Measures the allocations of the receive thread. Drawing runs on another thread and is not counted.</summary>
internal sealed class ReceiveAllocations
{
    private int _thread;
    private long _last;
    private long _total;

    /// <summary>Allocated bytes since the first frame. Thread-safe.</summary>
    public long Total => Volatile.Read(ref _total);

    /// <summary>Called on the receive thread with every frame. The first frame on a new thread only sets the starting value.</summary>
    public void OnFrame()
    {
        long now = GC.GetAllocatedBytesForCurrentThread();
        int thread = Environment.CurrentManagedThreadId;
        if (thread == _thread)
            Volatile.Write(ref _total, _total + now - _last);

        (_thread, _last) = (thread, now);
    }
}
