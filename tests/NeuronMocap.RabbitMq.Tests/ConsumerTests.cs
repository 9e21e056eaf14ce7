using System.IO.Pipelines;
using System.Reflection;
using NeuronMocap.RabbitMq.Connecting;
using NeuronMocap.RabbitMq.Consuming;
using NeuronMocap.Tests.Network;
using RabbitMQ.Client;
using RabbitMQ.Client.Events;

namespace NeuronMocap.RabbitMq.Tests;

public sealed class ConsumerTests
{
    // A broker closes a channel with messages that are not acknowledged for 30 minutes.
    [Fact]
    public async Task While_no_frames_come_the_last_ones_are_acknowledged_once()
    {
        var options = new RabbitMqSourceOptions();
        IChannel channel = DispatchProxy.Create<IChannel, AcknowledgementLog>();
        var acknowledged = ((AcknowledgementLog)(object)channel).Tags;
        var pipe = new Pipe(new PipeOptions(pauseWriterThreshold: 0));
        var consumer = new PacketConsumer(channel, new SourceState(options), pipe.Writer, options, restTime: Timeout.InfiniteTimeSpan);
        ulong tag = 0;

        async Task DeliverAsync(int count)
        {
            for (int i = 0; i < count; i++)
            {
                await consumer.HandleBasicDeliverAsync(
                    "tag", ++tag, redelivered: false, "exchange", "main.x.motion", new BasicProperties(), TestPackets.Motion((int)tag), TestContext.Current.CancellationToken);
            }
        }

        await DeliverAsync(70);
        Assert.Equal([64UL], acknowledged);
        await consumer.AcknowledgeRestAsync();
        await consumer.AcknowledgeRestAsync();
        Assert.Equal([64UL, 70UL], acknowledged);
        await DeliverAsync(64);
        Assert.Equal([64UL, 70UL, 134UL], acknowledged);
        await DeliverAsync(1);
        consumer.Stop();
        await consumer.AcknowledgeRestAsync();

        Assert.Equal([64UL, 70UL, 134UL], acknowledged);
        await pipe.Reader.CompleteAsync();
    }

    // NeuronReaderOptions.MaxValues can be higher than its default.
    [Fact]
    public void A_source_leaves_the_limit_of_values_to_its_reader()
    {
        var state = new SourceState(new RabbitMqSourceOptions());

        Assert.True(state.Take("main.x.motion", headers: null, TestPackets.Motion(1, count: 12_000)));
        Assert.Equal(0, state.GetStatistics().Invalid);
    }

    [Fact]
    public void A_reader_that_took_nothing_for_too_long_is_told_so()
    {
        var reason = new ShutdownEventArgs(
            ShutdownInitiator.Peer, 406, "PRECONDITION_FAILED - delivery acknowledgement on channel 1 timed out. Timeout value used: 1800000 ms.");

        Assert.Contains("the reader took no frames for too long", BrokerFault.Of(reason, new RabbitMqSourceOptions()).Message, StringComparison.Ordinal);
    }

    /// <summary>A channel that only remembers acknowledgements.</summary>
    public class AcknowledgementLog : DispatchProxy
    {
        public List<ulong> Tags { get; } = [];

        protected override object? Invoke(MethodInfo? targetMethod, object?[]? args)
        {
            Assert.Equal((nameof(IChannel.BasicAckAsync), true), (targetMethod?.Name, args?[1]));
            Tags.Add((ulong)args![0]!);
            return ValueTask.CompletedTask;
        }
    }
}
