using NeuronMocap.Transport;

namespace NeuronMocap.Recording;

// The file of a playback. It stays open until the player is disposed and the playback's thread has left it. Any thread.
internal sealed class PlaybackFile(RecordedEventSource source)
{
    private readonly object _lock = new();
    private bool _isInUse;
    private bool _isClosed;

    public RecordedEventSource Source => source;

    // The name in status messages.
    public string Target => source.Target;

    public bool IsClosed
    {
        get
        {
            lock (_lock)
                return _isClosed;
        }
    }

    public void Close()
    {
        lock (_lock)
        {
            bool isIdle = !_isInUse && !_isClosed;
            _isClosed = true;
            if (!isIdle)
                return;
        }

        source.Dispose();
    }

    // Playback thread. Only one exists at a time.
    public LinkEnd Use(Func<LinkEnd> action)
    {
        lock (_lock)
        {
            if (_isClosed)
                return Closed();

            _isInUse = true;
        }

        LinkEnd end;
        try
        {
            end = action();
        }
        catch (Exception exception)
        {
            end = new LinkEnd(ConnectionReason.NetworkError, ConnectionMessages.ReceivingFailed(Target, exception)) { IsFinal = true };
        }

        lock (_lock)
        {
            _isInUse = false;
            if (!_isClosed)
                return end;
        }

        source.Dispose();
        return end.IsFinal ? end : Closed();
    }

    private LinkEnd Closed() => new(ConnectionReason.EndOfRecording, $"The player of {Target} was disposed.") { IsFinal = true };
}
