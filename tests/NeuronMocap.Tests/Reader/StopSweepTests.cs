using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Reader;

public enum Situation
{
    Resolving,
    BlackHoled,
    BackOff,
    Idle,
    MidFrame,
    Streaming,
    UdpIdle,
    UdpStreaming,
}

public enum Stopping
{
    Dispose,
    DisposeAsync,
    CancelledStart,
    ThreeThreads,
    WhilePumping,
    StatusHandler,
    FrameHandler,
    PumpHandler,
}

// Starts that are stopped after 0 to 50 ms, in every situation and every way: 52 times 51 of them. Alone, because it counts sockets and threads of
// the whole process.
[Collection(nameof(Alone))]
public sealed partial class StopSweepTests(ITestOutputHelper output)
{
    private const int MaxDelay = 50;

    // The timeout of a stop that waits in vain.
    private static readonly TimeSpan StopTimeout = Limits.Unexpected;

    public static TheoryData<Situation, Stopping> All
    {
        get
        {
            var data = new TheoryData<Situation, Stopping>();
            foreach (Situation situation in Enum.GetValues<Situation>())
            {
                foreach (Stopping stopping in Enum.GetValues<Stopping>())
                {
                    bool hasFrames = situation is Situation.Streaming or Situation.UdpStreaming;
                    if (hasFrames || stopping is not (Stopping.FrameHandler or Stopping.PumpHandler))
                        data.Add(situation, stopping);
                }
            }

            return data;
        }
    }

    [Theory]
    [MemberData(nameof(All))]
    public Task Every_stop_completes_and_leaves_nothing(Situation situation, Stopping stopping) =>
        SweepAsync(situation, stopping, static () => TcpReceivers.Shared.Take());

    private async Task SweepAsync(Situation situation, Stopping stopping, Func<TcpReceiver> takeReceiver)
    {
        int sockets = ProcessResources.Sockets;
        int threads = ProcessResources.LibraryThreads;
        TimeSpan longest;
        await using (var surroundings = new Surroundings(situation, takeReceiver))
        {
            TimeSpan[] times = await Task.WhenAll(
                Enumerable.Range(0, MaxDelay + 1).Select(delay => new Start(surroundings.CreateReader(), stopping, delay, surroundings).RunAsync())).Soon();
            longest = times.Max();
            Assert.InRange(longest, TimeSpan.Zero, StopTimeout / 2);
        }

        output.WriteLine($"The longest of {MaxDelay + 1} stops took {longest.TotalMilliseconds:N1} ms.");
        await ProcessResources.AssertNoMoreAsync(sockets, threads);
    }

    // The environment of the readers of one situation.
    private sealed class Surroundings(Situation situation, Func<TcpReceiver> takeReceiver) : IAsyncDisposable
    {
        private static readonly byte[] Frame = TestPackets.Motion(1);

        private readonly CancellationTokenSource _end = new();
        private readonly BlackHole? _blackHole = situation == Situation.BlackHoled ? new BlackHole() : null;
        private readonly TestServer _server = new();
        private readonly List<Task> _running = [];
        private int _port;

        public NeuronReader CreateReader()
        {
            if (_port == 0)
                Open();

            var options = new NeuronReaderOptions
            {
                Port = _port,
                StopTimeout = StopTimeout,
                Reconnect = { InitialDelay = TimeSpan.FromMilliseconds(5), MaxDelay = TimeSpan.FromMilliseconds(20) },
            };
            if (situation is Situation.UdpIdle or Situation.UdpStreaming)
            {
                options.Transport = TransportKind.Udp;
                options.LocalAddress = IPAddress.Loopback;
                options.Port = 0;
            }

            if (situation == Situation.Resolving)
                return new NeuronReader(options, () => new TcpLink(options.Link with { Host = "suit-pc", Resolve = _ => new TaskCompletionSource<IPAddress[]>().Task }));

            return options.Transport == TransportKind.Udp ? new NeuronReader(options) : options.CreateReader(takeReceiver);
        }

        // Sends frames as fast as a test needs them.
        public async Task SendDatagramsAsync(NeuronReader reader)
        {
            if (situation != Situation.UdpStreaming)
                return;

            using var sender = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
            while (!reader.Completion.IsCompleted)
            {
                try
                {
                    if (reader.Status.LocalEndPoint is { } port)
                        sender.SendTo(Frame, port);
                }
                catch (SocketException)
                {
                    // The port is closed.
                }

                await Task.Delay(1);
            }
        }

        public async ValueTask DisposeAsync()
        {
            await _end.CancelAsync();
            _server.Dispose();
            _blackHole?.Dispose();
            await Task.WhenAll(_running).Soon();
            _end.Dispose();
        }

        private void Open()
        {
            _port = _blackHole?.Port ?? _server.Port;
            if (situation == Situation.BackOff)
                _server.Dispose();
            else
                _running.Add(ServeAsync());
        }

        private async Task ServeAsync()
        {
            List<Task> serving = [];
            try
            {
                while (true)
                    serving.Add(ServeAsync(await _server.AcceptAsync(_end.Token)));
            }
            catch (OperationCanceledException)
            {
                await Task.WhenAll(serving);
            }
        }

        private async Task ServeAsync(TestConnection connection)
        {
            using (connection)
            {
                try
                {
                    if (situation == Situation.MidFrame)
                        await connection.SendAsync(Frame.AsMemory(0, 700));

                    while (situation == Situation.Streaming)
                    {
                        await connection.SendAsync(Frame);
                        await Task.Delay(1, _end.Token);
                    }

                    await Task.Delay(Timeout.Infinite, _end.Token);
                }
                catch (Exception exception) when (exception is SocketException or OperationCanceledException)
                {
                    // The reader was stopped, or all were.
                }
            }
        }
    }

    // One start, and its end after a while. Returns the longest time of a call to Dispose.
    private sealed class Start(NeuronReader reader, Stopping stopping, int delay, Surroundings surroundings)
    {
        private readonly long _start = Stopwatch.GetTimestamp();
        private readonly object _lock = new();
        private TimeSpan _longest;
        private int _stopped;

        public async Task<TimeSpan> RunAsync()
        {
            Task sending = surroundings.SendDatagramsAsync(reader);
            FrameQueue queue = reader.OpenQueue();
            Task pumping = stopping is Stopping.WhilePumping or Stopping.PumpHandler ? OnThread(() => Pump(queue)) : Task.CompletedTask;
            if (stopping == Stopping.FrameHandler)
                reader.MotionReceived += _ => StopWhenDue();
            if (stopping == Stopping.StatusHandler)
                reader.StatusChanged += _ => StopWhenDue(wait: true);

            await StartAsync();
            await StopAsync();
            await reader.Completion.Soon();
            await Task.WhenAll(sending, pumping).Soon();
            Assert.Equal((ConnectionState.Stopped, ConnectionReason.Requested), (reader.Status.State, reader.Status.Reason));
            return _longest;
        }

        private static Task OnThread(Action action) => Task.Factory.StartNew(action, TaskCreationOptions.LongRunning);

        private async Task StartAsync()
        {
            if (stopping != Stopping.CancelledStart)
            {
                reader.Start();
                return;
            }

            using var cancellation = new CancellationTokenSource(delay);
            try
            {
                await reader.StartAsync(cancellation.Token);
            }
            catch (OperationCanceledException)
            {
                // Expected if no connection opens in time.
            }
        }

        private async Task StopAsync()
        {
            if (stopping is Stopping.StatusHandler or Stopping.FrameHandler or Stopping.PumpHandler)
                return;
            if (stopping != Stopping.CancelledStart)
                await Task.Delay(delay);

            if (stopping == Stopping.DisposeAsync)
                await MeasureAsync();
            else if (stopping == Stopping.ThreeThreads)
                await Task.WhenAll(OnThread(Measure), OnThread(Measure), MeasureAsync());
            else
                await OnThread(Measure);
        }

        private void Pump(FrameQueue queue)
        {
            while (!reader.Completion.IsCompleted)
            {
                queue.Pump<MotionFrame>(_ =>
                {
                    if (stopping == Stopping.PumpHandler)
                        StopWhenDue();
                });
                Thread.Sleep(1);
            }
        }

        private void StopWhenDue(bool wait = false)
        {
            TimeSpan remaining = TimeSpan.FromMilliseconds(delay) - Stopwatch.GetElapsedTime(_start);
            if (remaining > TimeSpan.Zero)
            {
                if (!wait)
                    return;

                Thread.Sleep(remaining);
            }

            if (Interlocked.Exchange(ref _stopped, 1) == 0)
                Measure();
        }

        private void Measure()
        {
            long before = Stopwatch.GetTimestamp();
            reader.Dispose();
            Note(before);
        }

        private async Task MeasureAsync()
        {
            long before = Stopwatch.GetTimestamp();
            await reader.DisposeAsync();
            Note(before);
        }

        private void Note(long before)
        {
            TimeSpan time = Stopwatch.GetElapsedTime(before);
            lock (_lock)
                _longest = time > _longest ? time : _longest;
        }
    }
}
