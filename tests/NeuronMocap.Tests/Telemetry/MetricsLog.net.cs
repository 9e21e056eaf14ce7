using System.Diagnostics.Metrics;

namespace NeuronMocap.Tests.Telemetry;

// Listens to the meter of one reader among those of all tests.
internal sealed class MetricsLog : IDisposable
{
    private readonly MeterListener _listener = new();
    private readonly string _reader;
    private readonly object _lock = new();
    private readonly List<(string Name, double Value, string Tags)> _measurements = [];

    public MetricsLog(string reader)
    {
        _reader = reader;
        _listener.InstrumentPublished = (instrument, listener) =>
        {
            if (instrument.Meter.Name != "NeuronMocap")
                return;

            Instruments.Add(instrument);
            listener.EnableMeasurementEvents(instrument);
        };
        _listener.SetMeasurementEventCallback<long>((instrument, value, tags, _) => Keep(instrument.Name, value, tags));
        _listener.SetMeasurementEventCallback<double>((instrument, value, tags, _) => Keep(instrument.Name, value, tags));
        _listener.Start();
    }

    public List<Instrument> Instruments { get; } = [];

    // Returns the current values of counters and gauges, in the order of the instruments, as "name tag=value ...: value".
    public string[] Collect()
    {
        lock (_lock)
            _measurements.Clear();

        _listener.RecordObservableInstruments();
        return [.. Measurements.Select(measurement => $"{measurement.Name}{measurement.Tags}: {measurement.Value}")];
    }

    public (string Name, double Value, string Tags)[] Measurements
    {
        get
        {
            lock (_lock)
                return [.. _measurements];
        }
    }

    public void Dispose() => _listener.Dispose();

    private void Keep(string name, double value, ReadOnlySpan<KeyValuePair<string, object?>> tags)
    {
        KeyValuePair<string, object?>[] all = tags.ToArray();
        if (!all.Contains(new("neuron.reader.name", _reader)))
            return;

        string rest = string.Concat(all.Where(tag => tag.Key != "neuron.reader.name").Select(tag => $" {tag.Key}={tag.Value}"));
        lock (_lock)
            _measurements.Add((name, value, rest));
    }
}
