namespace NeuronMocap.Tests.Playback;

/// <summary>Every frame of a reader as a line, with its timestamp.</summary>
internal sealed class FrameLog : IDisposable
{
    private readonly object _lock = new();
    private readonly List<(string Line, uint? Index, long Timestamp)> _frames = [];
    private readonly NeuronReader _reader;

    public FrameLog(NeuronReader reader)
    {
        _reader = reader;
        reader.MotionReceived += Add;
        reader.CalculationReceived += Add;
        reader.StudioCalculationReceived += Add;
    }

    public string[] Lines => Select(static frame => frame.Line);

    public uint?[] Indices => Select(static frame => frame.Index);

    public double[] Milliseconds => Select(static frame => Math.Round(FakeTime.MillisecondsOf(frame.Timestamp), 3));

    public Task WaitAsync(int count) => Limits.UntilAsync(() => Lines.Length >= count);

    public void Clear()
    {
        lock (_lock)
            _frames.Clear();
    }

    public void Dispose()
    {
        _reader.MotionReceived -= Add;
        _reader.CalculationReceived -= Add;
        _reader.StudioCalculationReceived -= Add;
    }

    private void Add(AvatarFrame frame)
    {
        lock (_lock)
            _frames.Add((Recordings.Describe(frame), frame.FrameIndex, frame.Timestamp));
    }

    private T[] Select<T>(Func<(string Line, uint? Index, long Timestamp), T> selector)
    {
        lock (_lock)
            return [.. _frames.Select(selector)];
    }
}
