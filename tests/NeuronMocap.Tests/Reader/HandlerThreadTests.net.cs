using System.Diagnostics.Metrics;

namespace NeuronMocap.Tests.Reader;

public sealed partial class HandlerThreadTests
{
    [Fact]
    public async Task A_listener_of_the_intervals_between_frames()
    {
        await using NeuronReader reader = Create();
        using var listener = new MeterListener();
        listener.InstrumentPublished = (instrument, self) =>
        {
            if (instrument.Name == "neuron.reader.frame.interval")
                self.EnableMeasurementEvents(instrument);
        };

        // The listener hears other readers of the process, too.
        listener.SetMeasurementEventCallback<double>((_, _, tags, _) =>
        {
            foreach (KeyValuePair<string, object?> tag in tags)
            {
                if (reader.Name.Equals(tag.Value))
                    Stop(reader);
            }
        });
        listener.Start();
        await AssertStopsAtOnceAsync(reader);
    }
}
