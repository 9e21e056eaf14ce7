using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Recording;

// Carries arrivals from the file to the parsers, and finds places. Playback thread.
internal sealed class PlaybackFeed
{
    // Silently read before a place, so that parsers know where packets begin when they come to it.
    private static readonly TimeSpan LeadIn = TimeSpan.FromSeconds(1);

    private static readonly TimeSpan BeforeAll = TimeSpan.FromTicks(-1);

    private readonly ArrivalSource _source;
    private readonly PlaybackReceiver _receiver = new();
    private readonly ArrivalParser _parser;
    private Arrival _arrival;
    private bool _hasArrival;

    // Bytes of the present arrival that were handed out: steps go frame by frame.
    private int _taken;

    public PlaybackFeed(ArrivalSource source, SenderFilter filter, int maxValues)
    {
        _source = source;
        _parser = new ArrivalParser(maxValues, filter, _receiver);
    }

    public ArrivalParser Parser => _parser;

    // Who gets what comes out of the parsers.
    public IPacketReceiver? Target
    {
        get => _receiver.Target;
        set => _receiver.Target = value;
    }

    public bool IsOfConnection(in Arrival arrival) => arrival.Kind == ArrivalKind.Bytes && _parser.Continues(arrival);

    // Whether a frame came out of the arrival; if not, it is over. Any splitting of a connection's bytes gives the same frames, a datagram is whole.
    public bool PushToFrame(in Arrival arrival, long timestamp)
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

    public void GoTo(TimeSpan place, Func<bool> isStopped)
    {
        Rewind(place - LeadIn);
        ReadSilently(place, isStopped);
        _receiver.Place(place);
    }

    // To before the frame that was shown so many frames before the one that was shown last.
    public void GoBack(int count, Func<bool> isStopped)
    {
        (TimeSpan shown, int ofTime) = (_receiver.FrameTime, _receiver.FramesOfTime);
        int further = count + (ofTime > 0 ? 1 : 0) - ofTime;
        for (TimeSpan leadIn = LeadIn; ; leadIn *= 2)
        {
            bool isStart = Rewind(shown - leadIn);
            long before = _receiver.Frames;
            ReadSilently(shown, isStopped);
            long skipped = _receiver.Frames - before - further;
            if (isStopped())
                return;
            if (skipped < 0 && !isStart)
                continue;

            Rewind(shown - leadIn);
            _receiver.Place(BeforeAll);
            SkipSilently(Math.Max(0, skipped), isStopped);
            return;
        }
    }

    // True where nothing precedes the place.
    public bool Rewind(TimeSpan place)
    {
        _receiver.IsMuted = true;
        _parser.Close();
        _receiver.IsMuted = false;
        _hasArrival = false;
        return _source.Seek(place > TimeSpan.Zero ? place : TimeSpan.Zero);
    }

    // What steps have left of it.
    public bool Follow(in Arrival arrival, long timestamp)
    {
        _receiver.Time = arrival.Time;
        return _parser.Follow(_taken == 0 ? arrival : arrival with { Bytes = arrival.Bytes.Slice(_taken) }, timestamp);
    }

    public Arrival Peek()
    {
        if (!_hasArrival)
        {
            _arrival = _source.Read();
            _hasArrival = true;
            _taken = 0;
        }

        return _arrival;
    }

    public void Advance() => _hasArrival = false;

    private void ReadSilently(TimeSpan until, Func<bool> isStopped)
    {
        _receiver.IsMuted = true;
        while (Peek() is { Kind: not ArrivalKind.End } arrival && arrival.Time < until && !isStopped())
        {
            Follow(arrival, timestamp: 0);
            Advance();
        }

        _parser.Settle();
        _receiver.IsMuted = false;
    }

    private void SkipSilently(long frames, Func<bool> isStopped)
    {
        _receiver.IsMuted = true;
        long end = _receiver.Frames + frames;
        while (_receiver.Frames < end && !isStopped() && Peek() is { Kind: not ArrivalKind.End } arrival)
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
}
