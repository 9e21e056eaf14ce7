using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Recording;

// The playback thread's side of a player: carries arrivals from the file to the parsers, and finds places.
internal sealed class PlaybackRun
{
    // Silently read before a place, so that parsers know where packets begin when they come to it.
    private static readonly TimeSpan LeadIn = TimeSpan.FromSeconds(1);

    private static readonly TimeSpan BeforeAll = TimeSpan.FromTicks(-1);

    private readonly RecordingPlayer _player;
    private readonly PlaybackControl _control;
    private readonly ArrivalSource _source;
    private readonly PlaybackReceiver _receiver = new();
    private readonly ArrivalParser _parser;
    private Arrival _arrival;
    private bool _hasArrival;

    // Whether the first connection has stood since the link opened.
    private bool _hasOpened;

    // Bytes of the present arrival that were handed out: steps go frame by frame.
    private int _taken;

    public PlaybackRun(RecordingPlayer player, SenderFilter filter, int maxValues)
    {
        _player = player;
        _control = player.Control;
        _source = player.Source;
        _parser = new ArrivalParser(maxValues, filter, _receiver);
    }

    // Waits until a connection stands.
    public LinkEnd Open(PlaybackLink link)
    {
        _hasOpened = false;
        while (!_parser.IsOpen)
        {
            Arrival arrival = Peek();
            switch (_control.WaitFor(arrival.Time, link, out _))
            {
                case PlaybackTurn.Stop:
                    return LinkEnd.Requested;
                case PlaybackTurn.Seek:
                    GoTo(_control.TakeSeek(), link);
                    continue;
                case PlaybackTurn.StepBack:
                    GoBack(_control.TakeStepsBack(), link);
                    continue;
                case PlaybackTurn.Step when arrival.Kind == ArrivalKind.End:
                    _control.EndStep();
                    continue;
            }

            if (arrival.Kind == ArrivalKind.End)
            {
                if (EndPass() is { } end)
                    return end;
            }
            else if (arrival.Kind == ArrivalKind.Bytes)
            {
                _parser.Open(arrival);
                _hasOpened |= !arrival.IsCalculation;
            }
            else
            {
                if (arrival.Kind == ArrivalKind.Opened)
                {
                    _parser.Open(arrival);
                    _hasOpened |= !arrival.IsCalculation;
                }

                Advance();
            }
        }

        return LinkEnd.None;
    }

    // Plays until the connection ends.
    public LinkEnd Receive(PlaybackLink link, IPacketReceiver receiver)
    {
        _receiver.Target = receiver;
        while (true)
        {
            Arrival arrival = Peek();
            PlaybackTurn turn = _control.WaitFor(arrival.Time, link, out long timestamp);
            if (turn == PlaybackTurn.Stop)
                return LinkEnd.Requested;

            if (turn is PlaybackTurn.Seek or PlaybackTurn.StepBack)
            {
                if (turn == PlaybackTurn.Seek)
                    GoTo(_control.TakeSeek(), link);
                else
                    GoBack(_control.TakeStepsBack(), link);

                if (!_parser.IsOpen)
                    return new LinkEnd(ConnectionReason.ClosedByPeer, "The playback has gone to another place, where no connection stood.");

                receiver.OnLinkOpened();
                continue;
            }

            if (turn == PlaybackTurn.Step && (arrival.Kind == ArrivalKind.End || IsOfConnection(arrival)))
            {
                if (arrival.Kind == ArrivalKind.End || PushToFrame(arrival, _control.StepTo(arrival.Time)))
                    _control.EndStep();

                continue;
            }

            if (Play(arrival, timestamp) is { } end)
                return end;
        }
    }

    // Recordings give the name of the reason.
    private static LinkEnd Ended(string? reason) =>
        Enum.TryParse(reason, out ConnectionReason recorded) && Enum.IsDefined(typeof(ConnectionReason), recorded) && recorded is not (ConnectionReason.None or ConnectionReason.Requested)
            ? new LinkEnd(recorded, $"The recorded connection ended: {reason}.")
            : new LinkEnd(ConnectionReason.ClosedByPeer, "The recorded connection ended.");

    // Null unless the connection ends.
    private LinkEnd? Play(in Arrival arrival, long timestamp)
    {
        if (arrival.Kind == ArrivalKind.End)
        {
            _parser.Close(arrival.Time);
            return EndPass() ?? new LinkEnd(ConnectionReason.EndOfRecording, $"The {_player.Target} begins again.");
        }

        // Another connection, of which the next link is: this one's end was not recorded.
        if (_parser.Ends(arrival))
        {
            _parser.Close();
            return Ended(reason: null);
        }

        // The first one may come to stand after that of calculation data.
        if (Follow(arrival, timestamp) && !arrival.IsCalculation)
        {
            if (_hasOpened)
                _receiver.Target!.OnLinkOpened();

            _hasOpened = true;
        }

        string? reason = arrival.Reason;
        Advance();
        if (_parser.IsOpen)
            return null;

        // The last connection's end is that of the recording, which comes next.
        return Peek().Kind == ArrivalKind.End ? null : Ended(reason);
    }

    // Null when another pass follows.
    private LinkEnd? EndPass()
    {
        if (!_control.BeginPass())
            return _player.Complete();

        Rewind(TimeSpan.Zero);
        return null;
    }

    private bool IsOfConnection(in Arrival arrival) => arrival.Kind == ArrivalKind.Bytes && _parser.Continues(arrival);

    // Whether a frame came out of the arrival; if not, it is over. Any splitting of a connection's bytes gives the same frames, a datagram is whole.
    private bool PushToFrame(in Arrival arrival, long timestamp)
    {
        long frames = _receiver.Frames;
        if (arrival.Transport == TransportKind.Udp)
        {
            Follow(arrival, timestamp);
            Advance();
            return _receiver.Frames > frames;
        }

        _receiver.Time = arrival.Time;
        while (_taken < arrival.Bytes.Count)
        {
            _parser.Follow(arrival with { Bytes = arrival.Bytes.Slice(_taken++, 1) }, timestamp);
            if (_receiver.Frames > frames)
                return true;
        }

        Advance();
        return false;
    }

    private void GoTo(TimeSpan place, PlaybackLink link)
    {
        Rewind(place - LeadIn);
        ReadSilently(place, link);
        _receiver.Place(place);
    }

    // To before the frame that was shown so many frames before the one that was shown last.
    private void GoBack(int count, PlaybackLink link)
    {
        (TimeSpan shown, int ofTime) = (_receiver.FrameTime, _receiver.FramesOfTime);
        int further = count + (ofTime > 0 ? 1 : 0) - ofTime;
        for (TimeSpan leadIn = LeadIn; ; leadIn *= 2)
        {
            bool isStart = Rewind(shown - leadIn);
            long before = _receiver.Frames;
            ReadSilently(shown, link);
            long skipped = _receiver.Frames - before - further;
            if (IsStopped(link))
                return;
            if (skipped < 0 && !isStart)
                continue;

            Rewind(shown - leadIn);
            _receiver.Place(BeforeAll);
            SkipSilently(Math.Max(0, skipped), link);
            return;
        }
    }

    // True where nothing precedes the place.
    private bool Rewind(TimeSpan place)
    {
        _receiver.IsMuted = true;
        _parser.Close();
        _receiver.IsMuted = false;
        _hasArrival = false;
        return _source.Seek(place > TimeSpan.Zero ? place : TimeSpan.Zero);
    }

    private void ReadSilently(TimeSpan until, PlaybackLink link)
    {
        _receiver.IsMuted = true;
        while (Peek() is { Kind: not ArrivalKind.End } arrival && arrival.Time < until && !IsStopped(link))
        {
            Follow(arrival, timestamp: 0);
            Advance();
        }

        _parser.Settle();
        _receiver.IsMuted = false;
    }

    private void SkipSilently(long frames, PlaybackLink link)
    {
        _receiver.IsMuted = true;
        long end = _receiver.Frames + frames;
        while (_receiver.Frames < end && !IsStopped(link) && Peek() is { Kind: not ArrivalKind.End } arrival)
        {
            if (arrival.Kind == ArrivalKind.Bytes)
            {
                _ = PushToFrame(arrival, timestamp: 0);
                continue;
            }

            Follow(arrival, timestamp: 0);
            Advance();
        }

        _parser.Settle();
        _receiver.IsMuted = false;
    }

    // A place may be far from where reading can begin: whoever closes the link or disposes of the player does not wait until it is found.
    private bool IsStopped(PlaybackLink link) => link.IsClosed || _control.IsOver;

    // What steps have left of it.
    private bool Follow(in Arrival arrival, long timestamp)
    {
        _receiver.Time = arrival.Time;
        return _parser.Follow(_taken == 0 ? arrival : arrival with { Bytes = arrival.Bytes.Slice(_taken) }, timestamp);
    }

    private Arrival Peek()
    {
        if (!_hasArrival)
        {
            _arrival = _source.Read();
            _hasArrival = true;
            _taken = 0;
        }

        return _arrival;
    }

    private void Advance() => _hasArrival = false;
}
