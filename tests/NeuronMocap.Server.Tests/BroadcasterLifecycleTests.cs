using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Server;

namespace NeuronMocap.Server.Tests;

public sealed class BroadcasterLifecycleTests
{
    [Fact]
    public void A_port_in_use_is_an_error_that_names_the_port()
    {
        int port = FreePort.Next();
        BroadcasterOptions options = Expect.Options();
        options.Port = port;
        using var first = new Broadcaster(options);
        first.Start();
        using var second = new Broadcaster(options);

        BroadcasterException exception = Assert.Throws<BroadcasterException>(second.Start);
        Assert.Contains($"Port {port} on 127.0.0.1 is in use by another program", exception.Message, StringComparison.Ordinal);
        Assert.Equal("Port", exception.Setting);

        // It can start again when the port is free.
        first.Dispose();
        second.Start();
        Assert.Equal(port, second.LocalEndPoint!.Port);
    }

    [Fact]
    public async Task A_port_can_be_taken_again_right_after_a_broadcast()
    {
        BroadcasterOptions options = Expect.Options(frames: 3);
        options.Port = FreePort.Next();
        for (int i = 0; i < 3; i++)
        {
            await using var broadcaster = new Broadcaster(options);
            broadcaster.Start();
            using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
            Assert.Equal(3, (await client.ReadToEndAsync()).Count);
        }
    }

    [Fact]
    public void An_address_of_another_machine_is_an_error_that_names_the_setting()
    {
        BroadcasterOptions options = Expect.Options();
        options.BindAddress = IPAddress.Parse("192.0.2.1");
        using var broadcaster = new Broadcaster(options);

        BroadcasterException exception = Assert.Throws<BroadcasterException>(broadcaster.Start);
        Assert.Equal("BindAddress", exception.Setting);
        Assert.Contains("192.0.2.1", exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task It_cannot_be_started_after_disposal()
    {
        var broadcaster = new Broadcaster(Expect.Options());
        broadcaster.Dispose();
        await broadcaster.DisposeAsync();
        await broadcaster.Completion.Soon();
        Assert.Throws<ObjectDisposedException>(broadcaster.Start);
    }

    [Fact]
    public void It_can_be_started_once()
    {
        using var broadcaster = new Broadcaster(Expect.Options());
        broadcaster.Start();
        Assert.Throws<InvalidOperationException>(broadcaster.Start);
    }

    [Theory]
    [InlineData(BroadcasterOptions.MaxFrameRate, false)]
    [InlineData(BroadcasterOptions.MaxFrameRate, true)]
    [InlineData(0.01, false)]
    [InlineData(0.01, true)]
    [InlineData(2000, false)]
    [InlineData(2000, true)]
    public async Task It_can_be_disposed_at_any_moment(double rate, bool hasClients)
    {
        BroadcasterOptions options = Expect.Options();
        options.Port = FreePort.Next();
        options.FrameRate = rate;
        options.WaitForClient = !hasClients;
        var broadcaster = new Broadcaster(options);
        broadcaster.Start();
        using TestClient? idle = hasClients ? await TestClient.ConnectAsync(broadcaster.LocalEndPoint) : null;
        using TestClient? gone = hasClients ? await TestClient.ConnectAsync(broadcaster.LocalEndPoint) : null;
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == (hasClients ? 2 : 0));
        gone?.Reset();

        Task again = Task.Run(broadcaster.Dispose, TestContext.Current.CancellationToken);
        await Task.WhenAll(broadcaster.DisposeAsync().AsTask(), again).Soon();
        await broadcaster.Completion.Soon();
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 0);
        using var late = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        Assert.Throws<SocketException>(() => late.Connect(broadcaster.LocalEndPoint!));
    }

    [Fact]
    public async Task It_can_be_disposed_while_it_waits_for_clients_at_the_end()
    {
        BroadcasterOptions options = Expect.Options(frames: 5);
        options.FrameRate = 1000;
        options.WaitForClient = true;
        options.CloseTimeout = TimeSpan.FromMinutes(10);
        var broadcaster = new Broadcaster(options);
        broadcaster.Start();
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        Assert.Equal(5, (await client.ReadToEndAsync()).Count);
        Assert.False(broadcaster.Completion.IsCompleted);

        await broadcaster.DisposeAsync().AsTask().Soon();
        await broadcaster.Completion.Soon();
    }

    [Theory]
    [InlineData(BroadcasterOptions.MaxFrameRate)]
    [InlineData(1000)]
    public async Task An_exception_of_a_source_faults_the_completion(double rate)
    {
        BroadcasterOptions options = Expect.Options();
        options.Sources = [new FailingSource(badFrame: 200)];
        await AssertEndsAsync(options, rate);
    }

    [Theory]
    [InlineData(BroadcasterOptions.MaxFrameRate)]
    [InlineData(1000)]
    public async Task An_exception_of_a_calculation_writer_faults_the_completion(double rate)
    {
        BroadcasterOptions options = Expect.Options();
        options.Calculation = static (_, frame, _) =>
        {
            if (frame == 20)
                throw new InvalidDataException("The writer is broken.");
        };
        await AssertEndsAsync(options, rate);
    }

    [Fact]
    public void Options_are_copied()
    {
        BroadcasterOptions options = Expect.Options();
        using var broadcaster = new Broadcaster(options);
        options.IncludeReference = true;
        Assert.Equal(354, broadcaster.Layout.ValueCount);
    }

    [Fact]
    public void Displacement_defaults_to_the_sources()
    {
        BroadcasterOptions options = Expect.Options();
        options.Sources = [new FailingSource(0)];
        Assert.Equal(new ChannelLayout(hasDisplacement: false, hasReference: false), new Broadcaster(options).Layout);
        options.IncludeDisplacement = true;
        Assert.Equal(new ChannelLayout(hasDisplacement: true, hasReference: false), new Broadcaster(options).Layout);
    }

    public static TheoryData<string, Action<BroadcasterOptions>> BadSettings { get; } = new()
    {
        { "Sources", options => options.Sources = [] },
        { "Sources", options => options.Sources = [null!] },
        { "Sources", options => options.Sources = [.. Enumerable.Range(0, 257).Select(i => new TestSource(i))] },
        { "AvatarNames", options => options.AvatarNames = ["one", "too many"] },
        { "AvatarNames", options => options.AvatarNames = [null!] },
        { "Port", options => options.Port = -1 },
        { "Port", options => options.Port = 65_536 },
        { "BindAddress", options => options.BindAddress = null! },
        { "MaxClients", options => options.MaxClients = 0 },
        { "MaxClients", options => options.MaxClients = 4097 },
        { "UdpDestinations", options => options.UdpDestinations = [null!] },
        { "UdpDestinations", options => options.UdpDestinations = [new IPEndPoint(IPAddress.Loopback, 0)] },
        { "FrameRate", options => options.FrameRate = 0 },
        { "FrameRate", options => options.FrameRate = -60 },
        { "FrameRate", options => options.FrameRate = double.NaN },
        { "FrameRate", options => options.FrameRate = 100_001 },
        { "MaxFrames", options => options.MaxFrames = 0 },
        { "RotationOrder", options => options.RotationOrder = (RotationOrder)6 },
        { "DataVersion", options => options.DataVersion = new DataVersion(2, 0, 0, 0) },
        { "CalculationValueCount", options => options.CalculationValueCount = 945 },
        { "Fragment", options => options.Fragment = 0 },
        { "Fragment", options => options.Fragment = 1_048_577 },
        { "QueueCapacity", options => options.QueueCapacity = 0 },
        { "ClientTimeout", options => options.ClientTimeout = TimeSpan.FromSeconds(0.9) },
        { "ClientTimeout", options => options.ClientTimeout = TimeSpan.FromHours(1) },
        { "CloseTimeout", options => options.CloseTimeout = TimeSpan.FromSeconds(-1) },
    };

    [Theory]
    [MemberData(nameof(BadSettings), DisableDiscoveryEnumeration = true)]
    public void A_setting_out_of_range_is_named(string setting, Action<BroadcasterOptions> spoil)
    {
        BroadcasterOptions options = Expect.Options();
        spoil(options);
        ArgumentException exception = Assert.Throws<ArgumentException>(() => new Broadcaster(options));
        Assert.Contains($"BroadcasterOptions.{setting} ", exception.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(double.NaN)]
    [InlineData(double.PositiveInfinity)]
    public void A_source_without_a_rate_needs_the_setting(double own)
    {
        BroadcasterOptions options = Expect.Options();
        options.Sources = [new FailingSource(0, own)];
        options.FrameRate = null;
        Assert.Throws<ArgumentException>("FrameRate", () => new Broadcaster(options));
        options.FrameRate = 50;
        Assert.Equal(50, new Broadcaster(options).FrameRate);
    }

    // The thread of a client that has left runs for a moment longer. The stop comes within that moment, in some of the rounds.
    [Fact]
    public async Task Every_thread_has_ended_after_the_stop()
    {
        for (int i = 0; i < 300; i++)
        {
            var started = new List<Worker>();
            BroadcasterOptions options = Expect.Options(frames: 1);
            options.WaitForClient = true;
            var broadcaster = new Broadcaster(options) { StartWorker = worker => { started.Add(worker); worker.Start(); } };
            broadcaster.Start();
            using (TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint))
                await client.ReadAsync();

            var wait = default(SpinWait);
            while (broadcaster.GetStatistics() is { Accepted: 0 } or { Clients: > 0 })
                wait.SpinOnce();

            broadcaster.Dispose();
            Assert.Equal([], started.Where(static worker => !worker.HasEnded).Select(static worker => worker.Name));
        }
    }

    private static async Task AssertEndsAsync(BroadcasterOptions options, double rate)
    {
        options.FrameRate = rate;
        options.WaitForClient = true;
        await using var broadcaster = new Broadcaster(options);
        broadcaster.Start();
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);

        await Assert.ThrowsAsync<InvalidDataException>(() => broadcaster.Completion.Soon());
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 0);
    }
}
