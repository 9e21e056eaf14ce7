using System.Diagnostics;
using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// Counts one kind of frame of one avatar. The receive thread writes, anyone reads: each figure is whole by itself.
internal sealed class AvatarTracker(PacketKind kind, int source, uint avatar)
{
    // A server that restarts, or is set to another take, starts counting elsewhere: a step beyond this is no gap.
    private const uint LargestGap = 10_000;

    // UDP may swap neighbours; a frame that comes this late is late, not a new start. One bit for each in the mask of those that came.
    private const int LargestDelay = 63;

    // So many frames in a row that are late and count up by one are no late frames: the server counts anew, as at the start of a take.
    private const int RestartRun = 3;

    // Weight of a new interval in the running mean: about half a second at 120 Hz.
    private const double Weight = 1.0 / 64;

    private AvatarName _name;
    private string _text = string.Empty;
    private uint? _lastIndex;
    private ulong _came;
    private uint _lateIndex;
    private int _lateRun;
    private long _lostBeforeRun;
    private long _disorderedBeforeRun;
    private long _lastTimestamp;
    private bool _resumed = true;
    private long _frames;
    private long _lost;
    private long _disordered;
    private long _intervals;
    private double _interval;
    private double _variance;

    public PacketKind Kind => kind;

    public int Source => source;

    public uint Avatar => avatar;

    public AvatarStatistics Snapshot => new()
    {
        Kind = kind,
        Source = source,
        AvatarIndex = (int)avatar,
        AvatarName = Volatile.Read(ref _text),
        Frames = Volatile.Read(ref _frames),
        Lost = Volatile.Read(ref _lost),
        Disordered = Volatile.Read(ref _disordered),
        Rate = Volatile.Read(ref _interval) is > 0 and var interval ? 1 / interval : 0,
        Jitter = TimeSpan.FromSeconds(Math.Sqrt(Math.Max(0, Volatile.Read(ref _variance)))),
        LastTimestamp = Volatile.Read(ref _lastTimestamp),
    };

    // What happened between two connections is neither a gap nor an interval.
    public void Resume() => _resumed = true;

    public void OnFrame(in AvatarName name, uint? index, long timestamp)
    {
        if (_frames == 0 || name != _name)
            Rename(name);
        if (!_resumed)
        {
            CountStep(index);
            Average((timestamp - _lastTimestamp) / (double)Stopwatch.Frequency);
        }
        else
        {
            StartAt(index);
            _resumed = false;
        }

        Volatile.Write(ref _lastTimestamp, timestamp);
        Volatile.Write(ref _frames, _frames + 1);
    }

    private void Rename(in AvatarName name)
    {
        _name = name;
        Volatile.Write(ref _text, Frames.AvatarNames.GetText(name));
    }

    // The index wraps at 2^32; unsigned differences do not care.
    private void CountStep(uint? index)
    {
        if (index is not { } next || _lastIndex is not { } last)
        {
            StartAt(index);
            return;
        }

        uint step = next - last;
        uint back = last - next;
        if (back <= LargestDelay)
        {
            CountLate(next, (int)back);
            return;
        }

        _lateRun = 0;
        if (step > LargestGap)
        {
            StartAt(next);
            return;
        }

        Volatile.Write(ref _lost, _lost + step - 1);
        _came = (step <= LargestDelay ? _came << (int)step : 0) | 1;
        _lastIndex = next;
    }

    private void CountLate(uint index, int back)
    {
        if (_lateRun == 0 || index != _lateIndex + 1)
        {
            _lateRun = 0;
            _lostBeforeRun = _lost;
            _disorderedBeforeRun = _disordered;
        }

        _lateIndex = index;
        if (++_lateRun == RestartRun)
        {
            Volatile.Write(ref _lost, _lostBeforeRun);
            Volatile.Write(ref _disordered, _disorderedBeforeRun);
            StartAt(index);
            return;
        }

        Volatile.Write(ref _disordered, _disordered + 1);
        ulong bit = 1UL << back;
        if ((_came & bit) == 0 && _lost > 0)
            Volatile.Write(ref _lost, _lost - 1);

        _came |= bit;
    }

    private void StartAt(uint? index)
    {
        _lastIndex = index;
        _came = 1;
        _lateRun = 0;
    }

    private void Average(double seconds)
    {
        // A plain mean until there are enough: the first intervals, of frames that came in one piece, would weigh too much.
        double weight = _intervals < 1 / Weight ? 1.0 / ++_intervals : Weight;
        double difference = seconds - _interval;
        Volatile.Write(ref _interval, _interval + (weight * difference));
        Volatile.Write(ref _variance, (1 - weight) * (_variance + (weight * difference * difference)));
    }
}
