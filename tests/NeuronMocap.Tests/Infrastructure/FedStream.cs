namespace NeuronMocap.Tests.Infrastructure;

// A stream that a test feeds with pieces. A read gives bytes of one piece, and waits if there is none.
internal sealed partial class FedStream : Stream
{
    private readonly object _lock = new();
    private readonly Queue<ArraySegment<byte>> _pieces = new();
    private Exception? _failure;
    private bool _hasEnded;
    private TaskCompletionSource<bool> _changed = NewSignal();

    // A stubborn stream: neither a cancellation nor a disposal ends a read.
    public bool IgnoresEnd { get; init; }

    // Whether an asynchronous read waits on the thread of its caller, as in a simple wrapper of a driver.
    public bool BlocksCallers { get; init; }

    // The result of an asynchronous read into an empty buffer; null to wait for bytes.
    public Func<Task<int>>? EmptyRead { get; init; }

    // Called by a disposal, before it ends reads.
    public Action Disposing { get; init; } = static () => { };

    public bool IsDisposed { get; private set; }

    // Number of reads that wait for bytes.
    public int Waiting { get; private set; }

    public override bool CanRead => !IsDisposed;

    public override bool CanSeek => false;

    public override bool CanWrite => false;

    public override long Length => throw new NotSupportedException();

    public override long Position
    {
        get => throw new NotSupportedException();
        set => throw new NotSupportedException();
    }

    public FedStream Feed(params byte[][] pieces)
    {
        Change(() =>
        {
            foreach (byte[] piece in pieces)
                _pieces.Enqueue(new ArraySegment<byte>(piece));
        });
        return this;
    }

    public FedStream End(Exception? failure = null)
    {
        Change(() => (_hasEnded, _failure) = (true, failure));
        return this;
    }

    public override int Read(byte[] buffer, int offset, int count)
    {
        while (true)
        {
            Task changed;
            lock (_lock)
            {
                if (TryTake(buffer.AsSpan(offset, count)) is { } taken)
                    return taken;

                changed = _changed.Task;
                Waiting++;
            }

            changed.GetAwaiter().GetResult();
        }
    }

    public override void Flush()
    {
    }

    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

    public override void SetLength(long value) => throw new NotSupportedException();

    public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();

    protected override void Dispose(bool disposing)
    {
        Disposing();
        Change(() => IsDisposed = true);
        base.Dispose(disposing);
    }

    // Null if there is nothing yet. A piece that does not fit is taken in parts.
    private int? TryTake(Span<byte> destination)
    {
        if (IsDisposed && !IgnoresEnd)
            throw new IOException("The stream was disposed.");
        if (_pieces.Count == 0)
            return !_hasEnded ? null : _failure is null ? 0 : throw _failure;
        if (destination.Length == 0)
            return 0;

        ArraySegment<byte> piece = _pieces.Dequeue();
        int count = Math.Min(piece.Count, destination.Length);
        piece.AsSpan(0, count).CopyTo(destination);
        if (count < piece.Count)
        {
            ArraySegment<byte>[] rest = [.. _pieces];
            _pieces.Clear();
            _pieces.Enqueue(new ArraySegment<byte>(piece.Array!, piece.Offset + count, piece.Count - count));
            foreach (ArraySegment<byte> later in rest)
                _pieces.Enqueue(later);
        }

        return count;
    }

    private void Change(Action change)
    {
        TaskCompletionSource<bool> changed;
        lock (_lock)
        {
            change();
            changed = _changed;
            _changed = NewSignal();
            Waiting = 0;
        }

        changed.TrySetResult(true);
    }

    private static TaskCompletionSource<bool> NewSignal() => new(TaskCreationOptions.RunContinuationsAsynchronously);
}
