using System.Diagnostics;
using System.Diagnostics.Metrics;
using NeuronMocap.Delivery;

namespace NeuronMocap.Telemetry;

// The part of a histogram for one reader or one consumer. Its tags are made once, so recording allocates nothing.
internal sealed class DurationRecorder(Histogram<double> histogram, params KeyValuePair<string, object?>[] tags) : IDurationRecorder
{
    private readonly KeyValuePair<string, object?>[] _motion = [.. tags, MeterTags.Motion];
    private readonly KeyValuePair<string, object?>[] _calculation = [.. tags, MeterTags.Calculation];
    private readonly KeyValuePair<string, object?>[] _studio = [.. tags, MeterTags.StudioCalculation];

    public bool IsEnabled => histogram.Enabled;

    public void Record(PacketKind kind, long ticks)
    {
        try
        {
            histogram.Record(ticks / (double)Stopwatch.Frequency, TagsOf(kind));
        }
        catch (Exception)
        {
            // A listener of the application threw. The meter cannot report that, and the receive loop continues.
        }
    }

    private KeyValuePair<string, object?>[] TagsOf(PacketKind kind) => kind switch
    {
        PacketKind.Motion => _motion,
        PacketKind.Calculation => _calculation,
        _ => _studio,
    };
}
