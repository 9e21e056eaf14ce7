using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Recording;

// Plays a file to a reader as the control specifies, connection after connection, until the file ends. Links run it on the playback's thread, one
// at a time.
internal sealed class PlaybackRun(PlaybackFile file, PlaybackControl control, PlaybackFeed feed, Action completed)
{
    // Whether the first connection has opened since the link opened.
    private bool _hasOpened;

    // The token of the link that plays.
    private CancellationToken _cancellationToken;
    private ILinkListener? _listener;

    // The number of the playback's thread while it plays, or 0. Other threads may see an old value.
    private int _thread;

    public string Target => file.Target;

    // Whether the playback's thread calls this.
    public bool IsCaller => _thread == Environment.CurrentManagedThreadId;

    // Waits until a connection is open.
    public LinkEnd Open(CancellationToken cancellationToken) => Use(() =>
    {
        _cancellationToken = cancellationToken;
        return Open();
    });

    // Plays until the connection ends.
    public LinkEnd Receive(IPacketReceiver receiver, ILinkListener? listener, CancellationToken cancellationToken) => Use(() =>
    {
        _cancellationToken = cancellationToken;
        _listener = listener;
        feed.Target = receiver;
        return Receive();
    });

    // Any thread. Called when a link was closed.
    public void Wake() => control.Wake();

    private LinkEnd Use(Func<LinkEnd> action)
    {
        _thread = Environment.CurrentManagedThreadId;
        try
        {
            LinkEnd end = file.Use(action);
            if (end.IsFinal || IsStopped())
                control.Leave();

            return end;
        }
        finally
        {
            _thread = 0;
        }
    }

    private LinkEnd Open()
    {
        _hasOpened = false;
        while (!feed.Parser.IsOpen)
        {
            RecordedEvent recorded = feed.Peek();
            switch (control.WaitFor(recorded.Time, _cancellationToken, out _))
            {
                case PlaybackAction.Stop:
                    return LinkEnd.Requested;
                case PlaybackAction.Seek:
                    feed.GoTo(control.TakeSeek(), IsStopped);
                    continue;
                case PlaybackAction.StepBack:
                    feed.GoBack(control.TakeStepsBack(), IsStopped);
                    continue;
                case PlaybackAction.Step when recorded.Kind == RecordedEventKind.End:
                    control.EndStep();
                    continue;
            }

            if (recorded.Kind == RecordedEventKind.End)
            {
                if (EndPass() is { } end)
                    return end;
            }
            else if (recorded.Kind == RecordedEventKind.Bytes)
            {
                feed.Parser.Open(recorded);
                _hasOpened |= !recorded.IsCalculation;
            }
            else
            {
                if (recorded.Kind == RecordedEventKind.Opened)
                {
                    feed.Parser.Open(recorded);
                    _hasOpened |= !recorded.IsCalculation;
                }

                feed.Advance();
            }
        }

        return LinkEnd.None;
    }

    private LinkEnd Receive()
    {
        while (true)
        {
            RecordedEvent recorded = feed.Peek();
            PlaybackAction turn = control.WaitFor(recorded.Time, _cancellationToken, out long timestamp);
            if (turn == PlaybackAction.Stop)
                return LinkEnd.Requested;

            if (turn is PlaybackAction.Seek or PlaybackAction.StepBack)
            {
                if (turn == PlaybackAction.Seek)
                    feed.GoTo(control.TakeSeek(), IsStopped);
                else
                    feed.GoBack(control.TakeStepsBack(), IsStopped);

                if (!feed.Parser.IsOpen)
                    return new LinkEnd(ConnectionReason.ClosedByPeer, "The playback has moved to a position without an open connection.");

                _listener?.OnLinkOpened();
                continue;
            }

            if (turn == PlaybackAction.Step && (recorded.Kind == RecordedEventKind.End || feed.IsOfConnection(recorded)))
            {
                if (recorded.Kind == RecordedEventKind.End || feed.PushToFrame(recorded, control.StepTo(recorded.Time)))
                    control.EndStep();

                continue;
            }

            if (Play(recorded, timestamp) is { } end)
                return end;
        }
    }

    // Recordings contain the name of the reason.
    private static LinkEnd Ended(string? reason) =>
        Enum.TryParse(reason, out ConnectionReason recorded) && Enum.IsDefined(typeof(ConnectionReason), recorded) && recorded is not (ConnectionReason.None or ConnectionReason.Requested)
            ? new LinkEnd(recorded, $"The recorded connection ended: {reason}.")
            : new LinkEnd(ConnectionReason.ClosedByPeer, "The recorded connection ended.");

    // Returns null unless the connection ends.
    private LinkEnd? Play(in RecordedEvent recorded, long timestamp)
    {
        if (recorded.Kind == RecordedEventKind.End)
        {
            feed.Parser.Close(recorded.Time);
            return EndPass() ?? new LinkEnd(ConnectionReason.EndOfRecording, $"The {file.Target} starts again.");
        }

        // The event belongs to another connection, which the next link plays. The end of this connection was not recorded.
        if (feed.Parser.Ends(recorded))
        {
            feed.Parser.Close();
            return Ended(reason: null);
        }

        // The first connection may open after that of calculation data.
        if (feed.Follow(recorded, timestamp) && !recorded.IsCalculation)
        {
            if (_hasOpened)
                _listener?.OnLinkOpened();

            _hasOpened = true;
        }

        string? reason = recorded.Reason;
        feed.Advance();
        if (feed.Parser.IsOpen)
            return null;

        // The end of the last connection is the end of the recording, which comes next.
        return feed.Peek().Kind == RecordedEventKind.End ? null : Ended(reason);
    }

    // Returns null if another pass follows.
    private LinkEnd? EndPass()
    {
        if (!control.BeginPass())
            return Complete();

        feed.Rewind(TimeSpan.Zero);
        return null;
    }

    private LinkEnd Complete()
    {
        completed();
        return new LinkEnd(ConnectionReason.EndOfRecording, $"The {file.Target} has ended.") { IsFinal = true };
    }

    // A position may be far from where reading can begin. Closing the link or disposing the player must not wait for the search.
    private bool IsStopped() => _cancellationToken.IsCancellationRequested || control.HasEnded;
}
