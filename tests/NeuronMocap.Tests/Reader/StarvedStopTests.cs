using NeuronMocap.Recording;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Playback;
using NeuronMocap.Tests.Recording;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Reader;

// Programs often block pool threads. A stop that waited for one of them would return after 2 s with nothing stopped.
[Collection(nameof(Alone))]
public sealed partial class StarvedStopTests : IDisposable
{
    private readonly TestServer _server = new();

    public void Dispose() => _server.Dispose();

    [Fact]
    public Task Before_any_thread_ran()
    {
        NeuronReaderOptions options = _server.Options();
        options.ReceiveThread = ReceiveThread.Pool;
        var reader = new NeuronReader(options);
        return StarvedPool.RunAsync(() =>
        {
            reader.Start();
            Stop(reader);
        });
    }

    [Fact]
    public async Task While_a_name_is_being_resolved()
    {
        var name = new UnansweredName();
        NeuronReader reader = name.CreateReader();
        reader.Start();
        await name.Asked.Soon();
        await StopAsync(reader);
    }

    [Fact]
    public Task While_connecting() => WhileConnectingAsync(() => new BlockingTcpReceiver());

    [Fact]
    public async Task While_waiting_for_the_next_attempt()
    {
        NeuronReaderOptions options = _server.Options(reconnect: true);
        options.Reconnect.InitialDelay = options.Reconnect.MaxDelay = TimeSpan.FromHours(1);
        var reader = new NeuronReader(options);
        var log = new StatusLog(reader);
        reader.Start();
        (await _server.AcceptAsync()).Close();
        await log.WaitAsync(ConnectionState.Waiting);
        await StopAsync(reader);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(2000)]
    public Task While_connected(int bytes) => WhileConnectedAsync(bytes, () => new BlockingTcpReceiver());

    [Theory]
    [InlineData(ReceiveThread.Auto)]
    [InlineData(ReceiveThread.Dedicated)]
    public async Task While_a_stream_waits(ReceiveThread thread)
    {
        using var stream = new FedStream();
        var reader = new NeuronReader(stream, SourceReaderTests.Options(thread));
        reader.Start();
        await Limits.UntilAsync(() => stream.Waiting > 0);
        await StopAsync(reader);
        Assert.True(stream.IsDisposed);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task While_receiving_UDP(bool receives)
    {
        await using UdpEnd end = await UdpEnd.StartAsync();
        if (receives)
        {
            await end.SendAsync(end.CreateSender(), TestPackets.Motion(1));
            await end.Reader.WaitForFramesAsync(1);
        }

        await StopAsync(end.Reader);
    }

    [Fact]
    public async Task While_it_records()
    {
        using var folder = new RecordingFolder();
        var reader = new NeuronReader(_server.Options());
        await reader.StartAsync().Soon();
        using TestConnection connection = await _server.AcceptAsync();
        StreamRecorder recorder = reader.StartRecording(folder.PathOf("take.nmrec"));
        await StopAsync(reader);
        Assert.True(recorder.Completion.IsCompleted);
    }

    [Fact]
    public async Task While_it_plays()
    {
        using TemporaryFile file = Playback.Recordings.OfTcp((0, TestPackets.Motion(1)), (3_600_000, TestPackets.Motion(2)));
        using RecordingPlayer player = RecordingPlayer.Open(file.Path);
        var reader = new NeuronReader(player, new NeuronReaderOptions { StopTimeout = Limits.Unexpected });
        reader.Start();
        await reader.WaitForFramesAsync(1);
        await StopAsync(reader);
    }

    [Fact]
    public async Task While_a_report_is_being_made()
    {
        using var leave = new SemaphoreSlim(0);
        var entered = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        var reader = new NeuronReader(_server.Options());
        reader.EventReported += reported =>
        {
            if (reported.Id != ReaderEventId.BytesSkipped)
                return;

            entered.TrySetResult();
            leave.Wait(Limits.Unexpected);
        };
        reader.Start();
        using TestConnection connection = await _server.AcceptAsync();
        await connection.SendAsync(TestPackets.Join(new byte[100], TestPackets.Motion(1)));
        await entered.Task.Soon();
        await StarvedPool.RunAsync(() =>
        {
            var leaving = new Thread(() =>
            {
                Thread.Sleep(100); // so that the stop finds the report in progress
                leave.Release();
            });
            leaving.Start();
            Stop(reader);
            leaving.Join();
        }).Soon();
    }

    private static async Task WhileConnectingAsync(Func<TcpReceiver> takeReceiver)
    {
        using var blackHole = new BlackHole();
        NeuronReader reader = new NeuronReaderOptions { Port = blackHole.Port, StopTimeout = Limits.Unexpected }.CreateReader(takeReceiver);
        var log = new StatusLog(reader);
        reader.Start();
        await log.WaitAsync(ConnectionState.Connecting);
        await StopAsync(reader);
    }

    private async Task WhileConnectedAsync(int bytes, Func<TcpReceiver> takeReceiver)
    {
        NeuronReader reader = _server.Options(reconnect: true).CreateReader(takeReceiver);
        await reader.StartAsync().Soon();
        using TestConnection connection = await _server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motions(0, 2).AsMemory(0, bytes));
        await reader.WaitForFramesAsync(bytes > 0 ? 1 : 0);
        await StopAsync(reader);
    }

    private static Task StopAsync(NeuronReader reader) => StarvedPool.RunAsync(() => Stop(reader)).Soon();

    private static void Stop(NeuronReader reader)
    {
        reader.Dispose();
        Assert.True(reader.Completion.IsCompleted);
        Assert.Equal((ConnectionState.Stopped, ConnectionReason.Requested), (reader.Status.State, reader.Status.Reason));
    }
}
