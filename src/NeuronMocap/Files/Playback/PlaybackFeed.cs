using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Recording;

// Moves events from the file to the parsers, and finds positions. Playback thread.
internal sealed class PlaybackFeed
{
    // This much is read silently before a position. The parsers then know where packets begin when they reach it.
    private static readonly TimeSpan LeadIn = TimeSpan.FromSeconds(1);

    private static readonly TimeSpan BeforeAll = TimeSpan.FromTicks(-1);

    private readonly RecordedEventSource _source;
    private readonly PlaybackReceiver _receiver = new();
    private readonly RecordedEventParser _parser;
    private RecordedEvent _event;
    private bool _hasEvent;

    // Number of delivered bytes of the current event. Steps go frame by frame.
    private int _taken;

    public PlaybackFeed(RecordedEventSource source, SenderFilter filter, int maxValues)
    {
        _source = source;
        _parser = new RecordedEventParser(maxValues, filter, _receiver);
    }

    public RecordedEventParser Parser => _parser;

    // Receives the output of the parsers.
    public IPacketReceiver? Target
    {
        get => _receiver.Target;
        set => _receiver.Target = value;
    }

    public bool IsOfConnection(in RecordedEvent recorded) => recorded.Kind == RecordedEventKind.Bytes && _parser.Continues(recorded);

    // Returns whether the event completed a frame. If not, the event is finished. The bytes of a connection can be split anywhere without changing
    // the frames; a datagram stays whole.
    public bool PushToFrame(in RecordedEvent recorded, long timestamp)
    {
        long frames = _receiver.Frames;
        if (recorded.Transport == TransportKind.Udp)
        {
            Follow(recorded, timestamp);
            Advance();
            return _receiver.Frames > frames;
        }

        _receiver.Time = recorded.Time;
        while (_taken < recorded.Bytes.Count)
        {
            _parser.Follow(recorded with { Bytes = recorded.Bytes.Slice(_taken++, 1) }, timestamp);
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

    // Moves back, to just before the frame that was shown the given number of frames before the last one.
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

    // Returns true if nothing precedes the position.
    public bool Rewind(TimeSpan place)
    {
        _receiver.IsMuted = true;
        _parser.Close();
        _receiver.IsMuted = false;
        _hasEvent = false;
        return _source.Seek(place > TimeSpan.Zero ? place : TimeSpan.Zero);
    }

    // Processes the part of the event that steps have left.
    public bool Follow(in RecordedEvent recorded, long timestamp)
    {
        _receiver.Time = recorded.Time;
        return _parser.Follow(_taken == 0 ? recorded : recorded with { Bytes = recorded.Bytes.Slice(_taken) }, timestamp);
    }

    public RecordedEvent Peek()
    {
        if (!_hasEvent)
        {
            _event = _source.Read();
            _hasEvent = true;
            _taken = 0;
        }

        return _event;
    }

    public void Advance() => _hasEvent = false;

    private void ReadSilently(TimeSpan until, Func<bool> isStopped)
    {
        _receiver.IsMuted = true;
        while (Peek() is { Kind: not RecordedEventKind.End } recorded && recorded.Time < until && !isStopped())
        {
            Follow(recorded, timestamp: 0);
            Advance();
        }

        _parser.Settle();
        _receiver.IsMuted = false;
    }

    private void SkipSilently(long frames, Func<bool> isStopped)
    {
        _receiver.IsMuted = true;
        long end = _receiver.Frames + frames;
        while (_receiver.Frames < end && !isStopped() && Peek() is { Kind: not RecordedEventKind.End } recorded)
        {
            if (recorded.Kind == RecordedEventKind.Bytes)
            {
                _ = PushToFrame(recorded, timestamp: 0);
                continue;
            }

            Follow(recorded, timestamp: 0);
            Advance();
        }

        _parser.Settle();
        _receiver.IsMuted = false;
    }
}
