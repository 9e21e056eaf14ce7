using System.Runtime.CompilerServices;
using NeuronMocap.Delivery;

namespace NeuronMocap;

// The waits of a consumer.
public sealed partial class FrameQueue
{
    // Both are published to the receive thread while it runs.
    private volatile FrameSignal? _signal;
    private volatile Action? _changed;
    private int _unsignalled;
    private int _awaiting;

    // Called on the receive thread after each frame, and when adding is completed.
    internal Action? Changed
    {
        get => _changed;
        set => _changed = value;
    }

    // Whether a consumer has something to do. In a flood, it waits for more.
    internal bool HasChanged => HasEnough || HasEnded;

    private bool HasEnded => _isComplete || _disposed;

    private bool HasEnough => Count >= (_signal is { IsFlooded: true } ? PartSize : 1);

    // A power of two, as the capacity.
    private int PartSize => Math.Max(1, Capacity / FrameSignal.PartsOfQueue);

    /// <summary>Waits until a frame is in the queue. Call <c>Pump</c> then, on any thread.</summary>
    /// <param name="cancellationToken">Ends the wait with an <see cref="OperationCanceledException"/>; the queue continues.</param>
    /// <returns>False if no frame will follow: the reader has stopped and the queue is empty, or the queue was disposed.</returns>
    /// <exception cref="InvalidOperationException">Another wait for this queue has not ended; it continues.</exception>
    /// <remarks>
    /// Only one wait at a time. The code after it runs on a pool thread, or on the caller's context. From about 40,000 frames a second on, such as those of an
    /// unpaced playback, it waits for more than one frame. A wait can then last a millisecond longer, and on Windows up to 16.
    /// </remarks>
    public ValueTask<bool> WaitAsync(CancellationToken cancellationToken = default)
    {
        // Also if frames wait: a loop that is slower than the stream would never end.
        if (cancellationToken.IsCancellationRequested)
            return new ValueTask<bool>(Task.FromCanceled<bool>(cancellationToken));

        return HasEnough && !_disposed ? new ValueTask<bool>(true) : WaitForFrameAsync(cancellationToken);
    }

    /// <summary>Blocks this thread until a frame is in the queue. Call <c>Pump</c> then.</summary>
    /// <param name="cancellationToken">Ends the wait with an <see cref="OperationCanceledException"/>; the queue continues.</param>
    /// <returns>False if no frame will follow: the reader has stopped and the queue is empty, or the queue was disposed.</returns>
    /// <exception cref="InvalidOperationException">Another wait for this queue has not ended; it continues.</exception>
    /// <remarks>
    /// <para>
    /// For a thread that does nothing else. At many thousands of frames a second, it takes less processor time than <see cref="WaitAsync"/>, because no
    /// thread pool takes part. Otherwise the same as <see cref="WaitAsync"/>.
    /// </para>
    /// <para>Do not call it in a handler of the reader. Handlers run on the receive thread, so no frame could arrive.</para>
    /// </remarks>
    public bool Wait(CancellationToken cancellationToken = default)
    {
        // Also if frames wait: a loop that is slower than the stream would never end.
        cancellationToken.ThrowIfCancellationRequested();
        return (HasEnough && !_disposed) || WaitForFrame(cancellationToken);
    }

    // Makes waits cheap from the first one on. Called before the queue gets its first frame.
    // clock: null for the usual one.
    internal void PrepareWaiting(Func<long>? clock = null)
    {
        var signal = new FrameSignal(this, clock);
        Changed = signal.Set;
        _signal = signal;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void OnAdded()
    {
        // While frames come faster than a consumer can wake, a wake-up for each part of the queue costs less. A frame without one costs no fence.
        if (_signal is not { IsFlooded: true } || (++_unsignalled & (PartSize - 1)) == 0)
            Changed?.Invoke();
    }

    private async ValueTask<bool> WaitForFrameAsync(CancellationToken cancellationToken)
    {
        FrameSignal signal = BeginWait();
        try
        {
            while (true)
            {
                bool hasEnded = HasEnded;
                if (!hasEnded && !HasEnough)
                    await signal.WaitAsync(cancellationToken).ConfigureAwait(false);
                if (Answer(hasEnded) is { } answer)
                    return answer;
            }
        }
        finally
        {
            EndWait();
        }
    }

    // The same on this thread.
    private bool WaitForFrame(CancellationToken cancellationToken)
    {
        FrameSignal signal = BeginWait();
        try
        {
            while (true)
            {
                bool hasEnded = HasEnded;
                if (!hasEnded && !HasEnough)
                    signal.Wait(cancellationToken);
                if (Answer(hasEnded) is { } answer)
                    return answer;
            }
        }
        finally
        {
            EndWait();
        }
    }

    // hasEnded was read before, because the last frame arrives before the end. Null if there is nothing to say yet.
    private bool? Answer(bool hasEnded) => Count > 0 && !_disposed ? true : hasEnded ? false : null;

    private FrameSignal BeginWait()
    {
        if (Interlocked.Exchange(ref _awaiting, 1) != 0)
            throw new InvalidOperationException("Only one wait at a time is possible for a queue. Open a queue for each consumer.");
        if (_signal is null)
            PrepareWaiting();

        return _signal!;
    }

    private void EndWait() => Volatile.Write(ref _awaiting, 0);
}
