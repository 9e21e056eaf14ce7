using System.Diagnostics.CodeAnalysis;

namespace NeuronMocap.Delivery;

// Wakes the one consumer that waits for a frame of a queue.
[SuppressMessage("Design", "CA1001", Justification = "The semaphore holds no handle, and the receive thread may release it after the end.")]
internal sealed class FrameSignal(FrameQueue queue)
{
    private readonly SemaphoreSlim _semaphore = new(0);
    private int _waiting;

    // Any thread. A full fence separates the packet, which is stored before, from the look at the announcement.
    public void Set()
    {
        if (Interlocked.Exchange(ref _waiting, 0) == 1)
            _semaphore.Release();
    }

    // May return too early.
    public async Task WaitAsync(TimeSpan limit, CancellationToken cancellationToken)
    {
        // Announces the wait, then looks again: what arrived before the announcement did not release the semaphore.
        Interlocked.Exchange(ref _waiting, 1);
        if (!queue.HasChanged)
            await _semaphore.WaitAsync(limit, cancellationToken).ConfigureAwait(false);

        Interlocked.Exchange(ref _waiting, 0);
    }
}
