namespace NeuronMocap.Tool.Watch.Live;

/// <summary>What the receive thread allocates. Drawing has a thread of its own and is not counted.</summary>
internal sealed class ReceiveAllocations
{
    private int _thread;
    private long _last;
    private long _total;

    /// <summary>Bytes from the first frame on. Any thread.</summary>
    public long Total => Volatile.Read(ref _total);

    /// <summary>Receive thread, with every frame. The first one of another thread only says where to count from.</summary>
    public void OnFrame()
    {
        long now = GC.GetAllocatedBytesForCurrentThread();
        int thread = Environment.CurrentManagedThreadId;
        if (thread == _thread)
            Volatile.Write(ref _total, _total + now - _last);

        (_thread, _last) = (thread, now);
    }
}
