using System.Diagnostics;
using System.Runtime.CompilerServices;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// One tracker's part of the totals of a reader.
internal readonly record struct LossTotals(long Lost, long Gaps, long Restarts)
{
    public LossTotals Add(LossTotals other) => new(Lost + other.Lost, Gaps + other.Gaps, Restarts + other.Restarts);
}

// Counts one kind of frame of one avatar. The receive thread writes, any thread reads; each figure is consistent on its own. A tracker that replaces
// others also carries their losses, so the sum over all trackers stays right.
internal sealed class AvatarTracker(
    PacketKind kind, int origin, uint avatar, IDurationRecorder? intervals = null, LossTotals forgotten = default)
{
    // Number of intervals in the running mean: about half a second at 120 Hz.
    private const int MeanLength = 64;

    private readonly IndexTracker _index = new();
    private readonly byte[] _name = new byte[ProtocolConstants.AvatarNameSize];
    private string _text = string.Empty;
    private long _lastTimestamp;
    private bool _resumed = true;
    private long _frames;
    private long _intervals;

    // In ticks, and in their square: a division for each frame would take a tenth of the time of the whole path.
    private double _interval;
    private double _variance;

    public PacketKind Kind => kind;

    public int Sender => PacketOrigin.SenderOf(Origin);

    // Receive loop only.
    public int Origin { get; private set; } = origin;

    public uint Avatar => avatar;

    public IndexTracker Index => _index;

    // Its own totals and those of its predecessors.
    public LossTotals Totals => new LossTotals(_index.Lost, _index.Gaps, _index.Restarts).Add(forgotten);

    // Receive loop only.
    public long LastTimestamp => _lastTimestamp;

    // The tracker whose frame came directly after this one's last frame. Receive loop only.
    public AvatarTracker? Next { get; set; }

    public AvatarStatistics Snapshot => new()
    {
        Kind = kind,
        Sender = Sender,
        AvatarIndex = (int)avatar,
        AvatarName = Volatile.Read(ref _text),
        Frames = Volatile.Read(ref _frames),
        Lost = _index.Lost,
        Gaps = _index.Gaps,
        OutOfOrder = _index.OutOfOrder,
        Restarts = _index.Restarts,
        FrequencyReduction = _index.Step,
        FrameRate = Volatile.Read(ref _interval) is > 0 and var interval ? Stopwatch.Frequency / interval : 0,
        Jitter = PreciseTime.FromSeconds(Math.Sqrt(Math.Max(0, Volatile.Read(ref _variance))) / Stopwatch.Frequency),
        LastTimestamp = Volatile.Read(ref _lastTimestamp),
    };

    // The time and the frames between two connections are neither an interval nor a gap.
    public void Resume() => _resumed = true;

    // The sender restarted and can start its frame numbers anywhere.
    public void Continue(int newOrigin)
    {
        Origin = newOrigin;
        _resumed = true;
        _index.Restart();
    }

    // name: the bytes of the header, which are compared as a whole.
    public void OnFrame(ReadOnlySpan<byte> name, uint? index, long timestamp)
    {
        if (!name.SequenceEqual(_name))
            Rename(name);
        if (!_resumed)
        {
            long interval = timestamp - _lastTimestamp;
            _index.OnIndex(index);
            Average(interval);
            if (intervals is { IsEnabled: true })
                intervals.Record(kind, interval);
        }
        else
        {
            _index.StartAt(index);
            _resumed = false;
        }

        Volatile.Write(ref _lastTimestamp, timestamp);
        Volatile.Write(ref _frames, _frames + 1);
    }

    private void Rename(ReadOnlySpan<byte> name)
    {
        name.CopyTo(_name);
        Volatile.Write(ref _text, AvatarNames.GetText(AvatarName.Read(name)));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Average(double ticks)
    {
        // Uses a plain mean until there are enough intervals. The first intervals, of frames that arrived in one chunk, would otherwise weigh too much.
        double weight = _intervals < MeanLength ? 1.0 / ++_intervals : 1.0 / MeanLength;
        double difference = ticks - _interval;
        Volatile.Write(ref _interval, _interval + (weight * difference));
        Volatile.Write(ref _variance, (1 - weight) * (_variance + (weight * difference * difference)));
    }
}
