using System.Diagnostics.Metrics;
using NeuronMocap.Delivery;

namespace NeuronMocap.Telemetry;

// One reader's part of the meter. The meter knows it until it is disposed.
internal sealed class ReaderMetrics : IDisposable
{
    private readonly KeyValuePair<string, object?> _tag;
    private volatile IReaderStatistics? _figures;

    public ReaderMetrics(string name)
    {
        Name = NeuronMeter.Add(name, this);
        _tag = new(MeterTags.Reader, Name);
        Intervals = new DurationRecorder(NeuronMeter.FrameInterval, _tag);
    }

    // The reader's name, with a number if another reader already has the name.
    public string Name { get; }

    public IDurationRecorder? Intervals { get; }

    // Null until the reader is made.
    public IReaderStatistics? Figures => _figures;

    public IDurationRecorder? HandOver(string consumer) =>
        new DurationRecorder(NeuronMeter.HandOver, _tag, new(MeterTags.Consumer, consumer));

    public void Observe(IReaderStatistics figures) => _figures = figures;

    public void Dispose() => NeuronMeter.Remove(this);

    public Measurement<T> Measure<T>(T value, params ReadOnlySpan<KeyValuePair<string, object?>> tags)
        where T : struct => new(value, [_tag, .. tags]);
}
