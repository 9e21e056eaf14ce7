using NeuronMocap.Frames;
using NeuronMocap.Skeleton;
using NeuronMocap.Timing;

namespace NeuronMocap.Tool.Convert;

/// <summary>An avatar of a stream, with its rate, its gaps and its pauses. Its memory does not grow with the frames.</summary>
internal sealed class StreamAvatar
{
    private readonly FrameTiming _timing = new();
    private readonly IndexTracker _indices = new();
    private readonly PauseFinder _pauses;
    private int? _connection;
    private uint? _lastIndex;
    private long _frames;
    private long _place;

    public StreamAvatar(int number, string name, SkeletonBody body)
    {
        (Number, Name, Body) = (number, name, body);
        _pauses = new PauseFinder(() => (_timing.MeasuredRate ?? Rate) * Step);
    }

    /// <summary>Its number in a table: that of the avatar, or another one if an avatar of another sender has it.</summary>
    public int Number { get; }

    /// <summary>Its name in its first frame. With another number than its own, also the number and the sender.</summary>
    public string Name { get; }

    /// <summary>The body that gives positions that its frames lack.</summary>
    public SkeletonBody Body { get; }

    /// <summary>Frames per second; null if the times do not give a rate.</summary>
    public double? Rate => _timing.Rate;

    /// <summary>Difference between the numbers of two consecutive frames.</summary>
    public int Step => _timing.Step;

    /// <summary>Number of gaps. A connection that ends and begins again is a gap.</summary>
    public long Gaps => _indices.Gaps + _indices.Restarts + Reconnections;

    /// <summary>Number of frames that are missing in the gaps, as far as the frames' numbers tell.</summary>
    public long MissingFrames => _indices.Lost;

    /// <summary>Whether the server numbers the frames, and does not always send the same number.</summary>
    public bool IsNumbered { get; private set; }

    private long Reconnections { get; set; }

    /// <summary>Gets the pauses after which the server continued its numbers. No frame may follow.</summary>
    public IReadOnlyList<Pause> GetPauses()
    {
        _pauses.Finish();
        return _pauses.Pauses;
    }

    public void Add(uint? index, TimeSpan time, int connection)
    {
        _timing.Add(index, time, connection);
        uint? newest = _indices.Newest;
        IndexChange change = IndexChange.None;
        if (_connection is { } last && connection != last)
        {
            Reconnections++;
            _indices.StartAt(index);
        }
        else
        {
            change = _indices.OnIndex(index);
        }

        if (change is not (IndexChange.Ahead or IndexChange.Late or IndexChange.Same))
            _pauses.Start();
        if (change is not (IndexChange.Late or IndexChange.Same) && index is not null)
            _pauses.Add(_frames, _place += change == IndexChange.Ahead ? index.Value - newest!.Value : 0, time);

        // StreamClock counts the same frames.
        _frames += index is null ? 0 : 1;
        IsNumbered |= index is not null && _lastIndex is not null && index != _lastIndex;
        (_lastIndex, _connection) = (index, connection);
    }
}
