using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Commands;
using NeuronMocap.Protocol;
using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Server;

namespace NeuronMocap.Server.Tests;

// User code that throws on a thread of a server: sources, writers of calculation data, handlers. An exception that left the thread would end this
// process.
public sealed class ServerFaultTests
{
    // Commands, and the member of the source that answers them.
    public static MatrixTheoryData<(int Id, string Member), Type> Questions { get; } = new(
        [(1001, "GetPose"), (1002, "GetPose"), (1004, "GetBody"), (1004, "Variant"), (1005, "GetBody"), (1005, "Variant"), (1005, "FrameRate")],
        [typeof(InvalidOperationException), typeof(ObjectDisposedException), typeof(OperationCanceledException), typeof(OutOfMemoryException)]);

    public static MatrixTheoryData<string, double, bool> Broadcasts { get; } = new(
        ["WriteValues", "Calculation", "StudioCalculation"], [BroadcasterOptions.MaxFrameRate, 200], [false, true]);

    [Theory, MemberData(nameof(Questions))]
    public async Task A_source_that_throws_for_a_command_closes_the_asking_connection((int Id, string Member) question, Type type)
    {
        var thrown = (Exception)Activator.CreateInstance(type, "The source is broken.")!;
        var source = new ThrowingSource(question.Member, thrown);
        using Broadcaster broadcaster = CommandServerTests.CreateBroadcaster(options => (options.Sources, options.FrameRate) = ([source], BroadcasterOptions.MaxFrameRate));
        using CommandServer server = CommandServerTests.Start(broadcaster);
        var told = new TaskCompletionSource<Exception>(TaskCreationOptions.RunContinuationsAsynchronously);
        server.Failed += _ => throw new InvalidOperationException("The handler is broken, too.");
        server.Failed += exception => told.TrySetResult(exception);
        source.IsBroken = true;
        using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        await socket.ConnectAsync(server.LocalEndPoint!, TestContext.Current.CancellationToken);
        socket.Send(CommandScript.Packet(question.Id == 1002 ? [] : [0, 0, 0, 0], question.Id));

        Assert.Same(thrown, await told.Task.Soon());
        Assert.Equal(0, await socket.ReceiveAsync(new byte[1], SocketFlags.None, TestContext.Current.CancellationToken).AsTask().Soon());
        await Limits.UntilAsync(() => server.ClientCount == 0);
        using NeuronCommandClient next = CommandServerTests.CreateClient(server);
        Assert.Equal(RotationOrder.YXZ, await next.GetRotationOrderAsync().Soon());
    }

    [Fact]
    public async Task An_exception_of_a_source_without_a_handler_ends_nothing()
    {
        var source = new ThrowingSource("GetBody", new InvalidOperationException("The source is broken."));
        using Broadcaster broadcaster = CommandServerTests.CreateBroadcaster(options => options.Sources = [source]);
        using CommandServer server = CommandServerTests.Start(broadcaster);
        source.IsBroken = true;
        for (int i = 0; i < 3; i++)
        {
            using NeuronCommandClient client = CommandServerTests.CreateClient(server);
            await CommandCall.FailsAsync(client.GetBoneDimensionsAsync(0), CommandFailure.Closed, "closed the connection");
        }
    }

    [Theory, MemberData(nameof(Broadcasts))]
    public async Task A_throwing_source_or_writer_ends_the_broadcast_with_a_reason(string member, double rate, bool isUdp)
    {
        using var receiver = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        receiver.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        var source = new ThrowingSource(member, new InvalidOperationException("The source is broken.")) { IsBroken = true };
        var options = new BroadcasterOptions
        {
            Sources = [source],
            FrameRate = rate,
            Port = isUdp ? null : 0,
            WaitForClient = !isUdp,
            UdpDestinations = isUdp ? [(IPEndPoint)receiver.LocalEndPoint!] : [],
            Format = member == "StudioCalculation" ? BroadcastFormat.Studio : BroadcastFormat.Binary,
            Calculation = member == "Calculation" ? static (_, _, _) => throw new InvalidOperationException("The writer is broken.") : null,
            StudioCalculation = member == "StudioCalculation" ? static (_, _, _) => throw new InvalidOperationException("The writer is broken.") : null,
        };
        await using var broadcaster = new Broadcaster(options);
        broadcaster.Start();
        if (!isUdp)
        {
            using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
            await EndAsync(client);
        }

        await Assert.ThrowsAsync<InvalidOperationException>(() => broadcaster.Completion.Soon());
    }

    [Theory]
    [InlineData(DataCommandId.BoneSize, "GetBody")]
    [InlineData(DataCommandId.BvhText, "GetBody")]
    [InlineData(DataCommandId.BvhText, "Variant")]
    public async Task A_source_that_throws_for_a_data_command_ends_the_broadcast_with_a_reason(DataCommandId id, string member)
    {
        var source = new ThrowingSource(member, new ObjectDisposedException("The source is broken."));
        await using Broadcaster broadcaster = CommandServerTests.CreateBroadcaster(options => options.Sources = [source]);
        broadcaster.Start();
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        Assert.NotNull(await client.ReadAsync());
        source.IsBroken = true;
        client.Socket.Send(Requests.Create((int)id, 0));
        await EndAsync(client);
        await Assert.ThrowsAsync<ObjectDisposedException>(() => broadcaster.Completion.Soon());
    }

    [Fact]
    public async Task A_listener_survives_exceptions_of_its_callback()
    {
        var report = new FaultReport("test");
        int failures = 0;
        var served = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        report.Failed += _ => failures++;
        using var listener = new NeuronMocap.Server.Clients.ClientListener(new IPEndPoint(IPAddress.Loopback, 0), Accept, report);
        listener.Worker.Start();
        using TestClient first = await TestClient.ConnectAsync(listener.LocalEndPoint);
        Assert.Null(await first.ReadAsync());
        using TestClient second = await TestClient.ConnectAsync(listener.LocalEndPoint);
        await served.Task.Soon();
        Assert.Equal(1, failures);

        void Accept(Socket socket)
        {
            if (failures == 0)
                throw new InvalidOperationException("The callback is broken.");

            socket.Dispose();
            served.SetResult();
        }
    }

    [Fact]
    public void A_worker_reports_its_exception_to_every_handler_and_ends()
    {
        var report = new FaultReport("test");
        var told = new List<Exception>();
        report.Failed += _ => throw new InvalidOperationException("The handler is broken.");
        report.Failed += told.Add;
        var thrown = new InvalidDataException("The body is broken.");
        var worker = new Worker("test", () => throw thrown, report);
        worker.Start();
        worker.Join(Stopwatch.GetTimestamp() + (long)(Limits.Unexpected.TotalSeconds * Stopwatch.Frequency));

        Assert.Same(thrown, Assert.Single(told));
    }

    [Fact]
    public void An_unhandled_first_failure_is_traced_despite_a_throwing_listener()
    {
        string marker = Guid.NewGuid().ToString();
        using var listener = new BrokenTraceListener(marker);
        Trace.Listeners.Add(listener);
        try
        {
            var report = new FaultReport("test");
            report.Report(new InvalidDataException(marker));
            report.Report(new InvalidDataException(marker));
            Assert.Equal(1, listener.Count);
        }
        finally
        {
            Trace.Listeners.Remove(listener);
        }
    }

    // The connection is closed gracefully, or reset if frames are in transit.
    private static async Task EndAsync(TestClient client)
    {
        try
        {
            await client.ReadToEndAsync();
        }
        catch (SocketException)
        {
        }
    }

    private sealed class BrokenTraceListener(string marker) : TraceListener
    {
        public int Count { get; private set; }

        public override void Write(string? message) => WriteLine(message);

        public override void WriteLine(string? message)
        {
            if (message?.Contains(marker, StringComparison.Ordinal) != true)
                return;

            Count++;
            throw new InvalidOperationException("The trace listener is broken.");
        }
    }
}
