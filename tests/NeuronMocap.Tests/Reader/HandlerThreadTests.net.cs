using System.Diagnostics.Metrics;
using NeuronMocap.Protocol;
using NeuronMocap.Reader;
using NeuronMocap.Tests.Delivery;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

public sealed partial class HandlerThreadTests
{
    [Fact]
    public async Task A_listener_of_the_intervals_between_frames()
    {
        await using NeuronReader reader = Create();
        using MeterListener listener = Listen((_, _, tags, _) =>
        {
            foreach (KeyValuePair<string, object?> tag in tags)
            {
                if (reader.Name.Equals(tag.Value))
                    Stop(reader);
            }
        });
        await AssertStopsAtOnceAsync(reader);
    }

    [Fact]
    public void The_mark_ends_with_the_listener()
    {
        ReceivePipeline pipeline = DeliveryBench.CreatePipeline();
        bool wasMarked = false;
        using MeterListener listener = Listen((_, _, _, _) =>
        {
            if (pipeline.HandlerThreadNumber == Environment.CurrentManagedThreadId)
                wasMarked = true;
        });
        for (int i = 0; i < 2; i++)
            pipeline.OnPacket(new ReceivedPacket(PacketKind.Motion, TestPackets.Motion(i), timestamp: i, origin: 0));

        Assert.Equal((true, 0), (wasMarked, pipeline.HandlerThreadNumber));
    }

    // The listener hears all readers of the process.
    private static MeterListener Listen(MeasurementCallback<double> heard)
    {
        var listener = new MeterListener
        {
            InstrumentPublished = static (instrument, self) =>
            {
                if (instrument.Name == "neuron.reader.frame.interval")
                    self.EnableMeasurementEvents(instrument);
            },
        };
        listener.SetMeasurementEventCallback(heard);
        listener.Start();
        return listener;
    }
}
