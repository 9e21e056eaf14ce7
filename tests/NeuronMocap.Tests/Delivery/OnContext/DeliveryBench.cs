using NeuronMocap.Protocol;
using NeuronMocap.Reader;
using NeuronMocap.Skeleton;
using NeuronMocap.Telemetry;
using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Delivery;

/// <summary>A delivery on a context that the test runs. The test's thread is the receive thread too.</summary>
internal sealed class DeliveryBench
{
    private readonly ReceivePipeline _pipeline;

    public DeliveryBench(FrameDeliveryOptions? options = null)
    {
        _pipeline = CreatePipeline();
        options ??= new FrameDeliveryOptions();
        if (options.Post is null)
            options.Context ??= Context;
        Delivery = _pipeline.OpenDelivery(options, Clock, _ => Closed++);
        Delivery.MotionReceived += frame => Seen.Add((frame.AvatarIndex, frame.FrameIndex));
    }

    public ManualContext Context { get; } = new();

    public FakeDeliveryClock Clock { get; } = new();

    public FrameDelivery Delivery { get; }

    /// <summary>The delivered motion frames.</summary>
    public List<(int Avatar, uint? Index)> Seen { get; } = [];

    public IEnumerable<uint?> Indices => Seen.Select(static frame => frame.Index);

    public int Closed { get; private set; }

    /// <summary>The end that is reported to those who wait for it.</summary>
    public FrameDeliveryEnd End
    {
        get
        {
            Assert.Equal(TaskStatus.RanToCompletion, Delivery.Completion.Status);
            return Delivery.End!;
        }
    }

    public ReaderStatistics Statistics => _pipeline.GetStatistics();

    public ReceivePipeline Pipeline => _pipeline;

    public static ReceivePipeline CreatePipeline()
    {
        var status = new StatusPublisher(static _ => { });
        return new ReceivePipeline(
            SkeletonFormat.Default,
            new StreamRecognizer(SkeletonFormat.Default),
            new LinkActivity(status, TimeSpan.FromSeconds(3), udpSenders: null),
            status,
            [new SenderFilter([])],
            new ReaderMetrics("delivery"),
            static _ => false,
            new ReaderRecordings(new NeuronReaderOptions(), "delivery"),
            static exception => throw exception);
    }

    public void Push(int frame, int avatar = 0) => Push(PacketKind.Motion, TestPackets.Motion(frame, avatar));

    public void Push(PacketKind kind, byte[] packet) => _pipeline.OnPacket(new ReceivedPacket(kind, packet, Clock.Now, 0));

    public void PushMany(int first, int count)
    {
        for (int i = 0; i < count; i++)
            Push(first + i);
    }

    public void Report(ConnectionState state) => Delivery.OnStatus(new ConnectionStatus(state, ConnectionReason.None, state.ToString()));

    /// <summary>Every frame that arrived has exactly one fate.</summary>
    public void AssertSumsAddUp() => Assert.Equal(Statistics.Frames, Delivery.Delivered + Delivery.Dropped + Delivery.Skipped + Delivery.Replaced + Delivery.Pending);
}
