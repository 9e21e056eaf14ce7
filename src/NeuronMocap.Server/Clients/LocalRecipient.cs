using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server.Clients;

/// <summary>A recipient in this process, which takes the bytes of the feed on its own thread.</summary>
internal sealed class LocalRecipient : Recipient
{
    private readonly object _lock = new();
    private readonly Action<Recipient, Exception?> _ended;
    private readonly byte[] _frames;
    private int _taken;
    private int _filled;
    private long _motion;
    private long _calculation;
    private volatile bool _isStopped;
    private int _hasEnded;

    // ended is called once, when the stream is disposed or a source fails, with the exception of the source.
    public LocalRecipient(BroadcastStream stream, FrameFeed feed, Action<Recipient, Exception?> ended)
        : base(stream, feed)
    {
        _ended = ended;
        _frames = new byte[Plan.MaxFrameSize];
    }

    // Waits for bytes. Returns their number, and 0 at the end.
    public int Read(Span<byte> destination)
    {
        try
        {
            lock (_lock)
                return Take(destination);
        }
        catch (Exception exception) when (exception is not OutOfMemoryException)
        {
            End(SourceError);
            throw;
        }
    }

    // The wait of Read ends at once. Its thread may still be inside.
    public override void Stop()
    {
        _isStopped = true;
        Feed.Wake();
    }

    public override void Dispose()
    {
        Stop();
        lock (_lock)
            End(error: null);
    }

    private int Take(Span<byte> destination)
    {
        while (_taken == _filled && !_isStopped && !HadAll)
        {
            FrameBatch batch = ReadFeed(_frames);
            (_taken, _filled) = (0, batch.Bytes);
            int motion = Plan.CountMotion(batch);
            _motion += motion;
            _calculation += Plan.HasCalculation ? batch.Packets - motion : 0;
            SetFrames(_motion, _calculation);
            HadAll = Feed.IsAtEnd;
            if (batch.Bytes == 0 && Feed.HasEnded)
                break;
        }

        if (_isStopped)
            return 0;

        int count = Math.Min(destination.Length, _filled - _taken);
        _frames.AsSpan(_taken, count).CopyTo(destination);
        _taken += count;
        CountBytes(count);
        return count;
    }

    private void End(Exception? error)
    {
        if (Interlocked.Exchange(ref _hasEnded, 1) != 0)
            return;

        _isStopped = true;
        Feed.Close();
        _ended(this, error);
    }
}
