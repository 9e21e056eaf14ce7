using NeuronMocap.Protocol;
using NeuronMocap.Reader;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Delivery;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

// Code of the application that runs on the receive thread can stop the reader. The stop then does not wait for that thread, so it is complete at once.
public sealed partial class HandlerThreadTests : IDisposable
{
    private readonly TestServer _server = new();
    private readonly TaskCompletionSource<bool> _stopped = new(TaskCreationOptions.RunContinuationsAsynchronously);

    public void Dispose() => _server.Dispose();

    [Fact]
    public async Task A_handler_of_frames()
    {
        await using NeuronReader reader = Create();
        reader.MotionReceived += _ => Stop(reader);
        await AssertStopsAtOnceAsync(reader);
    }

    [Fact]
    public async Task A_handler_of_replies()
    {
        await using NeuronReader reader = Create();
        reader.DataCommands.Received += _ => Stop(reader);
        await AssertStopsAtOnceAsync(reader);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task A_handler_of_either_connection(bool isCalculation)
    {
        using var calculation = new TestServer();
        NeuronReaderOptions options = _server.Options();
        options.StopTimeout = Limits.Unexpected;
        options.CalculationPort = calculation.Port;
        await using var reader = new NeuronReader(options);
        if (isCalculation)
            reader.CalculationReceived += _ => Stop(reader);
        else
            reader.MotionReceived += _ => Stop(reader);

        reader.Start();
        using TestConnection motions = await _server.AcceptAsync();
        using TestConnection calculations = await calculation.AcceptAsync();
        await (isCalculation ? calculations.SendAsync(TestPackets.Calculation(1)) : motions.SendAsync(TestPackets.Motion(1)));
        Assert.True(await _stopped.Task.Soon());
    }

    [Fact]
    public async Task Another_thread_waits_while_a_handler_runs()
    {
        await using NeuronReader reader = Create();
        using var leave = new SemaphoreSlim(0);
        reader.MotionReceived += _ =>
        {
            _stopped.TrySetResult(true);
            leave.Wait(Limits.Unexpected);
        };
        reader.Start();
        using TestConnection connection = await _server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        await _stopped.Task.Soon();
        Task stopping = reader.DisposeAsync().AsTask();
        Assert.False(stopping.IsCompleted);
        leave.Release();
        await stopping.Soon();
    }

    // Without a reader, which would also post changes of its status, from other threads.
    [Theory]
    [InlineData(Code.FrameHandler)]
    [InlineData(Code.ReplyHandler)]
    [InlineData(Code.Post)]
    public void The_mark_ends_with_the_code(Code code)
    {
        ReceivePipeline pipeline = DeliveryBench.CreatePipeline();
        int during = 0;
        Action look = () => during = pipeline.HandlerThreadNumber;
        Func<Action, bool> post = _ =>
        {
            look();
            return true;
        };
        if (code == Code.FrameHandler)
            pipeline.Callbacks.Motion.Add(_ => look());
        else if (code == Code.ReplyHandler)
            pipeline.Commands.Received += _ => look();
        else
            pipeline.OpenDelivery(new FrameDeliveryOptions { Post = post }, new FakeDeliveryClock(), static _ => { });

        pipeline.OnPacket(new ReceivedPacket(PacketKind.Command, DataReplies.AvatarCount(1), timestamp: 1, origin: 0));
        pipeline.OnPacket(new ReceivedPacket(PacketKind.Motion, TestPackets.Motion(1), timestamp: 1, origin: 0));
        Assert.Equal((Environment.CurrentManagedThreadId, 0), (during, pipeline.HandlerThreadNumber));
    }

    private NeuronReader Create()
    {
        NeuronReaderOptions options = _server.Options();
        options.StopTimeout = Limits.Unexpected;
        return new NeuronReader(options);
    }

    private void Stop(NeuronReader reader) => _stopped.TrySetResult(reader.DisposeAsync().AsTask().IsCompleted);

    private async Task AssertStopsAtOnceAsync(NeuronReader reader)
    {
        reader.Start();
        using TestConnection connection = await _server.AcceptAsync();
        await connection.SendAsync(TestPackets.Join(DataReplies.AvatarCount(1), TestPackets.Motions(1, 3)));
        Assert.True(await _stopped.Task.Soon());
    }

    public enum Code
    {
        FrameHandler,
        ReplyHandler,
        Post,
    }
}
