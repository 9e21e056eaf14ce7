using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Server;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Reader;

// Where datagrams may come from and go to.
public sealed class UdpSenderTests
{
    [Fact]
    public async Task Datagrams_of_blocked_senders_are_dropped_and_counted()
    {
        Loopback.NeedManyAddresses();
        await using UdpEnd end = await UdpEnd.StartAsync(options => options.AllowedSenders = [IPAddress.Parse("127.0.77.6"), IPAddress.Parse("127.0.77.7")]);
        Socket[] senders = [end.CreateSender("127.0.77.6"), end.CreateSender("127.0.77.7"), end.CreateSender("127.0.77.8")];
        for (int i = 0; i < 50; i++)
        {
            foreach (Socket sender in senders)
            {
                await end.SendAsync(sender, TestPackets.Motion(i).AsMemory(0, 1024));
                await end.SendAsync(sender, TestPackets.Motion(i).AsMemory(1024));
            }
        }

        await end.Reader.UntilAsync(static statistics => statistics is { MotionFrames: 100, RefusedDatagrams: 100 });
        Assert.Equal((0L, 0L), (end.Reader.GetStatistics().BytesSkipped, end.Reader.GetStatistics().Lost));
        Assert.Equal(2, end.Reader.GetAvatarStatistics().Count);
    }

    [Fact]
    public async Task Silence_names_blocked_senders_and_the_setting()
    {
        Loopback.NeedManyAddresses();
        await using UdpEnd end = await UdpEnd.StartAsync(options => options.AllowedSenders = [IPAddress.Parse("127.0.77.6")]);
        var log = new StatusLog(end.Reader);
        Socket refused = end.CreateSender("127.0.77.8");
        Socket allowed = end.CreateSender("127.0.77.6");
        Task<ConnectionStatus> told = log.WaitAsync(status => status.Reason == ConnectionReason.SenderNotAllowed);
        while (!told.IsCompleted)
        {
            await end.SendAsync(refused, TestPackets.Motion(1));
            await Task.Delay(1, TestContext.Current.CancellationToken);
        }

        ConnectionStatus silent = await told;
        Assert.Equal(ConnectionState.Silent, silent.State);
        Assert.Contains("127.0.77.8", silent.Message, StringComparison.Ordinal);
        Assert.Contains("AllowedSenders", silent.Message, StringComparison.Ordinal);

        await end.SendAsync(allowed, TestPackets.Motion(1));
        await log.WaitAsync(ConnectionState.Receiving);

        // Then there is no sender, which is another state.
        await log.WaitAsync(status => status is { State: ConnectionState.Silent, Reason: ConnectionReason.NoData });
    }

    [Fact]
    public async Task Each_of_two_ports_tells_its_own_blocked_senders()
    {
        Loopback.NeedManyAddresses();
        (int first, int second) = (FreePort.Next(), FreePort.Next());
        await using var reader = new NeuronReader(new NeuronReaderOptions
        {
            Transport = TransportKind.Udp,
            Port = first,
            CalculationPort = second,
            AllowedSenders = [IPAddress.Parse("127.0.77.6")],
            SilenceTimeout = TimeSpan.FromMilliseconds(100),
        });
        var log = new StatusLog(reader);
        await reader.StartAsync(TestContext.Current.CancellationToken).Soon();
        using var refused = new UdpClient(new IPEndPoint(IPAddress.Parse("127.0.77.8"), 0));
        await Limits.UntilAsync(() =>
        {
            refused.Send(TestPackets.Calculation(1), new IPEndPoint(IPAddress.Loopback, second));
            return reader.CalculationStatus is { Reason: ConnectionReason.SenderNotAllowed } && log.All.Any(static status => status.State == ConnectionState.Silent);
        });
        Assert.DoesNotContain(log.All, static status => status.Reason == ConnectionReason.SenderNotAllowed);
        Assert.True(reader.GetStatistics().RefusedDatagrams > 0);
    }

    [Fact]
    public async Task Allowed_senders_match_their_IPv6_addresses()
    {
        Loopback.NeedIPv6();
        foreach (bool isAllowed in (bool[])[true, false])
        {
            await using UdpEnd end = await UdpEnd.StartAsync(options =>
            {
                options.LocalAddress = IPAddress.IPv6Loopback;
                options.AllowedSenders = [isAllowed ? IPAddress.IPv6Loopback : IPAddress.Parse("fe80::1")];
            });
            await end.SendAsync(end.CreateSender(), TestPackets.Motion(1));
            await end.Reader.UntilAsync(static statistics => statistics.MotionFrames + statistics.RefusedDatagrams == 1);
            Assert.Equal(isAllowed ? 1 : 0, end.Reader.GetStatistics().MotionFrames);
        }
    }

    [Fact]
    public void A_list_with_a_null_is_refused()
    {
        var options = new NeuronReaderOptions { AllowedSenders = [null!] };
        Assert.Contains("AllowedSenders", Assert.Throws<ArgumentException>(() => new NeuronReader(options)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_list_is_copied()
    {
        List<IPAddress> allowed = [IPAddress.Parse("192.0.2.1")];
        await using UdpEnd end = await UdpEnd.StartAsync(options => options.AllowedSenders = allowed);
        allowed.Clear();
        await end.SendAsync(end.CreateSender(), TestPackets.Motion(1));
        await Limits.UntilAsync(() => end.Reader.GetStatistics().RefusedDatagrams == 1);
    }

    [Fact]
    public async Task A_reader_defaults_to_every_interface_and_a_broadcaster_to_loopback()
    {
        await using UdpEnd end = await UdpEnd.StartAsync(options => options.LocalAddress = null);
        Assert.Equal(IPAddress.Any, end.EndPoint.Address);
        await using var broadcaster = new Broadcaster(Expect.Options());
        broadcaster.Start();
        Assert.Equal(IPAddress.Loopback, broadcaster.LocalEndPoint!.Address);
    }

    [Fact]
    public async Task A_reader_bound_to_an_address_ignores_others()
    {
        Loopback.NeedManyAddresses();
        await using UdpEnd end = await UdpEnd.StartAsync(options => options.LocalAddress = IPAddress.Parse("127.0.77.9"));
        using var stray = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        for (int i = 0; i < 10; i++)
            stray.SendTo(TestPackets.Motion(i), new IPEndPoint(IPAddress.Parse("127.0.77.10"), end.EndPoint.Port));

        await end.SendAsync(end.CreateSender(), TestPackets.Motion(99));
        await end.Reader.WaitForFramesAsync(1);
        Assert.Equal(1480, end.Reader.GetStatistics().BytesReceived);
    }
}

// Alone, because it measures the memory of the whole process.
[Collection(nameof(Alone))]
public sealed class UdpFloodTests
{
    [Fact]
    public async Task A_flood_of_senders_takes_bounded_memory_and_loses_no_real_frames()
    {
        Loopback.NeedManyAddresses();
        const int Forged = 5000;
        byte[] whole = TestPackets.Motion(1);
        byte[] half = whole[..1024];
        await using UdpEnd end = await UdpEnd.StartAsync();
        Socket real = end.CreateSender();
        long heap = 0;
        for (int i = 0; i < Forged; i++)
        {
            if (i == 2000)
            {
                await end.DrainedAsync();
                heap = ProcessResources.LiveHeap();
            }

            using var forged = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
            forged.Bind(new IPEndPoint(new IPAddress([127, 1, (byte)(i / 250), (byte)(1 + (i % 250))]), 0));
            forged.Connect(end.EndPoint);
            await end.SendAsync(forged, i % 2 == 0 ? whole : half);
            if (i % 25 != 0)
                continue;

            await end.SendAsync(real, TestPackets.Motion(i).AsMemory(0, 1024));
            await end.SendAsync(real, TestPackets.Motion(i).AsMemory(1024));
        }

        // The real sender sends before the flood has taken all places, and keeps its place.
        const int Frames = Forged / 25;
        await end.DrainedAsync();
        await end.Reader.UntilAsync(_ => end.Reader.GetAvatarStatistics().Any(avatar => avatar.Frames == Frames));
        heap = ProcessResources.LiveHeap() - heap;

        // There is room for 64 assemblers of 4 KiB.
        Assert.InRange(heap, long.MinValue, 1_000_000);
        Assert.InRange(end.Reader.GetStatistics().BytesSkipped, 1024 * ((Forged / 2) - UdpSenders.Limit), 1504 * Forged);
    }
}
