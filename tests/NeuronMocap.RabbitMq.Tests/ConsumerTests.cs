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
    private readonly RabbitMqSourceOptions _options = new();

    // A broker closes a channel with messages that are not acknowledged for 30 minutes.
    [Fact]
    public async Task While_no_frames_come_the_last_ones_are_acknowledged_once()
    {
        IChannel channel = DispatchProxy.Create<IChannel, AcknowledgementLog>();
        var acknowledged = ((AcknowledgementLog)(object)channel).Tags;
        var pipe = new Pipe(new PipeOptions(pauseWriterThreshold: 0));
        PacketConsumer consumer = Create(channel, new SourceState(_options), pipe);
        ulong tag = 0;

        async Task DeliverAsync(int count)
        {
            for (int i = 0; i < count; i++)
                await ConsumerTests.DeliverAsync(consumer, ++tag);
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

    // A frame that was counted and not written would be lost without a count, because the next connection begins behind it.
    [Fact]
    public async Task Every_counted_frame_is_in_the_pipe_when_the_queue_is_deleted_meanwhile()
    {
        const int Connections = 500;
        IChannel channel = DispatchProxy.Create<IChannel, AcknowledgementLog>();
        using var begin = new Barrier(2);
        for (int i = 0; i < Connections; i++)
        {
            var state = new SourceState(_options);
            var pipe = new Pipe(new PipeOptions(pauseWriterThreshold: 0));
            PacketConsumer consumer = Create(channel, state, pipe);
            Task delivering = Task.Run(async () =>
            {
                begin.SignalAndWait(TestContext.Current.CancellationToken);
                for (ulong tag = 1; consumer.Failure is null; tag++)
                    await DeliverAsync(consumer, tag);
            });
            begin.SignalAndWait(TestContext.Current.CancellationToken);
            SpinWait.SpinUntil(() => state.GetStatistics().Packets > 0 || delivering.IsCompleted);
            await consumer.HandleBasicCancelAsync("tag", TestContext.Current.CancellationToken);
            await delivering;

            using var written = new MemoryStream();
            await pipe.Reader.CopyToAsync(written, TestContext.Current.CancellationToken);
            Assert.Equal(state.GetStatistics().Bytes, written.Length);
        }
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

    private PacketConsumer Create(IChannel channel, SourceState state, Pipe pipe) =>
        new(channel, state, pipe.Writer, _options, restTime: Timeout.InfiniteTimeSpan);

    private static Task DeliverAsync(PacketConsumer consumer, ulong tag) => consumer.HandleBasicDeliverAsync(
        "tag", tag, redelivered: false, "exchange", "main.x.motion", new BasicProperties(), TestPackets.Motion((int)tag), TestContext.Current.CancellationToken);

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
