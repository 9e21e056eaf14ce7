using NeuronMocap.Frames;
using NeuronMocap.Skeleton;
using NeuronMocap.Timing;

namespace NeuronMocap.Tool.Convert;

/// <summary>An avatar of a stream, with its rate and its gaps. Its memory does not grow with the frames.</summary>
/// <param name="name">Its name in its first frame.</param>
/// <param name="body">The body that gives positions that its frames lack.</param>
internal sealed class StreamAvatar(string name, SkeletonBody body)
{
    private readonly FrameTiming _timing = new();
    private readonly IndexTracker _indices = new();
    private int? _connection;
    private uint? _lastIndex;

    public string Name => name;

    public SkeletonBody Body => body;

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

    public void Add(uint? index, TimeSpan time, int connection)
    {
        _timing.Add(index, time, connection);
        if (_connection is { } last && connection != last)
        {
            Reconnections++;
            _indices.StartAt(index);
        }
        else
        {
            _indices.OnIndex(index);
        }

        IsNumbered |= index is not null && _lastIndex is not null && index != _lastIndex;
        (_lastIndex, _connection) = (index, connection);
    }
}
