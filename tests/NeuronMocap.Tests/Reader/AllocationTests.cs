using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server;
using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Reader;

// Receive threads change from read to read, so these tests measure the whole process and run alone.
[CollectionDefinition(nameof(Alone), DisableParallelization = true)]
public sealed class Alone;

[Collection(nameof(Alone))]
public sealed partial class AllocationTests
{
    private const int FramesPerRound = 200;

    // As datagrams, they fit the smallest buffer that a system grants.
    private const int MostInTransit = 50;

    private static readonly byte[] Frame = TestPackets.Motion(1);

    [Fact]
    public Task A_callback_costs_no_allocation_per_frame() => MeasureTcpAsync(reader =>
    {
        int frames = 0;
        float sum = 0;
        reader.MotionReceived += frame =>
        {
            sum += frame.GetPosition(Bone.Head).Y + frame.GetRotation(Bone.Hips).W + frame.AvatarName.Length;
            Interlocked.Increment(ref frames);
        };
        return () => Interlocked.Exchange(ref frames, 0);
    });

    [Fact]
    public async Task Two_connections_cost_no_allocation_per_frame()
    {
        byte[] calculationFrame = TestPackets.Calculation(1);
        using var motionServer = new TestServer();
        using var calculationServer = new TestServer();
        NeuronReaderOptions options = motionServer.Options();
        (options.CalculationPort, options.ReceiveThread) = (calculationServer.Port, ReceiveThread.Dedicated);
        using var reader = new NeuronReader(options);
        int frames = 0;
        reader.MotionReceived += _ => Interlocked.Increment(ref frames);
        reader.CalculationReceived += _ => Interlocked.Increment(ref frames);
        reader.Start();
        using TestConnection motion = await motionServer.AcceptAsync();
        using TestConnection calculation = await calculationServer.AcceptAsync();
        AssertNothingAllocated(
            () =>
            {
                motion.Socket.Send(Frame);
                calculation.Socket.Send(calculationFrame);
                return 2;
            },
            () => Interlocked.Exchange(ref frames, 0));
    }

    [Fact]
    public Task A_queue_costs_no_allocation_per_frame() => MeasureTcpAsync(reader =>
    {
        FrameQueue queue = reader.OpenQueue(FramesPerRound);
        float sum = 0;
        Action<MotionFrame> handler = frame => sum += frame.Values[^1];
        return () => queue.Pump(handler);
    });

    [Fact]
    public Task Newest_frames_cost_no_allocation_per_frame() => MeasureTcpAsync(reader =>
    {
        LatestFrames latest = reader.OpenLatest();
        int counted = 0;
        int frames = 0;
        reader.MotionReceived += _ => Interlocked.Increment(ref counted);
        return () =>
        {
            // Newer frames replace frames not yet taken. The round is over when all have arrived.
            if (latest.TryTakeMotion(0, out MotionFrame? frame))
                frames += frame.Values.Length;

            return Interlocked.Exchange(ref counted, 0);
        };
    });

    [Theory]
    [InlineData(WhenFull.DropOldest)]
    [InlineData(WhenFull.Wait)]
    public Task Other_kinds_of_full_queues_cost_no_allocation_per_frame(WhenFull whenFull) => MeasureTcpAsync(reader =>
    {
        FrameQueue queue = reader.OpenQueue(new FrameQueueOptions { Capacity = 8, WhenFull = whenFull });
        float sum = 0;
        long seen = 0;
        Action<MotionFrame> handler = frame => sum += frame.Values[^1];
        return () =>
        {
            queue.Pump(handler);
            long left = queue.Delivered + queue.Dropped;
            int taken = (int)(left - seen);
            seen = left;
            return taken;
        };
    });

    [Theory]
    [InlineData(0, 3)]
    [InlineData(500, 1)]
    public Task Skipped_frames_cost_no_allocation(double maxRate, int everyNth) => MeasureTcpAsync(reader =>
    {
        FrameQueue queue = reader.OpenQueue(new FrameQueueOptions { Capacity = FramesPerRound, MaxRate = maxRate, EveryNth = everyNth });
        LatestFrames latest = reader.OpenLatest(new LatestFramesOptions { MaxRate = maxRate, EveryNth = everyNth });
        float sum = 0;
        long seen = 0;
        Action<MotionFrame> handler = frame => sum += frame.Values[^1];
        return () =>
        {
            if (latest.TryTakeMotion(0, out MotionFrame? frame))
                sum += frame.Values[0];

            queue.Pump(handler);
            long left = queue.Delivered + queue.Skipped;
            int taken = (int)(left - seen);
            seen = left;
            return taken;
        };
    });

    [Theory]
    [InlineData(ReceiveThread.Auto)]
    [InlineData(ReceiveThread.Dedicated)]
    public async Task Datagrams_cost_no_allocation_per_frame(ReceiveThread thread)
    {
        using var reader = new NeuronReader(new NeuronReaderOptions
        {
            Transport = TransportKind.Udp,
            LocalAddress = IPAddress.Loopback,
            Port = 0,
            ReceiveThread = thread,
        });
        int frames = 0;
        reader.MotionReceived += _ => Interlocked.Increment(ref frames);
        await reader.StartAsync().Soon();
        using var first = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        using var second = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        first.Connect(reader.Status.LocalEndPoint!);
        second.Connect(reader.Status.LocalEndPoint!);

        // Two senders in turn, each frame in two datagrams, so that every datagram comes from another address than the one before.
        AssertNothingAllocated(
            () =>
            {
                first.Send(Frame, 0, 1024, SocketFlags.None);
                second.Send(Frame, 0, 1024, SocketFlags.None);
                first.Send(Frame, 1024, 456, SocketFlags.None);
                second.Send(Frame, 1024, 456, SocketFlags.None);
                return 2;
            },
            () => Interlocked.Exchange(ref frames, 0));
    }

    [Fact]
    public Task Lines_of_text_cost_no_allocation_per_frame() => MeasureTcpAsync(CountMotion, frame: TestPackets.Line(1));

    [Fact]
    public Task Frames_of_axis_studio_cost_no_allocation_per_frame() => MeasureTcpAsync(CountMotion, frame: AsOfStudio(TestPackets.Motion(1)));

    [Fact]
    public Task Axis_studios_calculation_frames_cost_no_allocation_per_frame() => MeasureTcpAsync(
        reader =>
        {
            int frames = 0;
            float sum = 0;
            reader.StudioCalculationReceived += frame =>
            {
                sum += frame.GetPosition(Bone.Head).Y + frame.AvatarName.Length;
                Interlocked.Increment(ref frames);
            };
            return () => Interlocked.Exchange(ref frames, 0);
        },
        frame: TestPackets.Studio(1));

    [Fact]
    public Task A_stream_with_a_thread_costs_no_allocation_per_frame() =>
        MeasureStreamAsync(static stream => new NeuronReader(stream, SourceReaderTests.Options(ReceiveThread.Dedicated)));

    [Theory]
    [InlineData(ReceiveThread.Auto)]
    [InlineData(ReceiveThread.Pool)]
    public void A_broadcast_in_this_process_costs_no_allocation_per_frame(ReceiveThread thread)
    {
        using var broadcaster = new Broadcaster(new BroadcasterOptions { Sources = [new SyntheticSource()], Port = null, FrameRate = 2000 });
        using var reader = new NeuronReader(SourceReaderTests.Options(thread, broadcaster.CreateLocalSource()));
        Func<int> take = CountMotion(reader);
        broadcaster.Start();
        reader.Start();

        // The broadcaster sends by itself, so what is received counts as sent.
        int received = 0;
        AssertNothingAllocated(
            () =>
            {
                Thread.Yield();
                return received = take();
            },
            () => Interlocked.Exchange(ref received, 0));
    }

    private static async Task MeasureStreamAsync(Func<Stream, NeuronReader> create)
    {
        using var server = new TestServer();
        var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        socket.Connect(IPAddress.Loopback, server.Port);
        using NeuronReader reader = create(new NetworkStream(socket, ownsSocket: true));
        Func<int> take = CountMotion(reader);
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        AssertNothingAllocated(
            () =>
            {
                connection.Socket.Send(Frame, 0, 700, SocketFlags.None);
                connection.Socket.Send(Frame, 700, Frame.Length - 700, SocketFlags.None);
                return 1;
            },
            take);
    }

    private static Func<int> CountMotion(NeuronReader reader)
    {
        int frames = 0;
        float sum = 0;
        reader.MotionReceived += frame =>
        {
            sum += frame.GetRotation(Bone.Hips).W + (frame.Timecode?.Seconds ?? 0) + (int)frame.Format.RotationOrder;
            Interlocked.Increment(ref frames);
        };
        return () => Interlocked.Exchange(ref frames, 0);
    }

    private static byte[] AsOfStudio(byte[] packet)
    {
        (packet[2], packet[50], packet[54]) = (1, 4, 30);
        return packet;
    }

    private static async Task MeasureTcpAsync(Func<NeuronReader, Func<int>> open, Func<TcpReceiver>? takeReceiver = null, byte[]? frame = null)
    {
        byte[] sent = frame ?? Frame;
        using var server = new TestServer();
        using var reader = server.Options().CreateReader(takeReceiver ?? (static () => new BlockingTcpReceiver()));
        Func<int> take = open(reader);
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        AssertNothingAllocated(
            () =>
            {
                connection.Socket.Send(sent, 0, 700, SocketFlags.None);
                connection.Socket.Send(sent, 700, sent.Length - 700, SocketFlags.None);
                return 1;
            },
            take);
    }

    // send returns the number of frames sent. take returns the number of frames received since the last call.
    private static void AssertNothingAllocated(Func<int> send, Func<int> take)
    {
        Run(send, take);
        Run(send, take);
        Assert.Equal(0, Allocations.LeastOfProcess(() => Run(send, take)));
    }

    private static void Run(Func<int> send, Func<int> take)
    {
        int sent = 0;
        int taken = 0;
        long start = Stopwatch.GetTimestamp();
        while (sent < FramesPerRound || taken < sent)
        {
            if (sent < FramesPerRound && sent - taken < MostInTransit)
                sent += send();
            else
                Thread.Yield();

            taken += take();
            if (Stopwatch.GetElapsedTime(start) > Limits.Unexpected)
                Assert.Fail($"{taken} of {sent} frames arrived");
        }
    }
}
