using System.Net;
using System.Net.Sockets;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Server;
using static NeuronMocap.Server.Tests.Broadcasts;

namespace NeuronMocap.Server.Tests;

public sealed class BroadcasterUdpTests
{
    [Theory]
    [InlineData(BroadcasterOptions.MaxFrameRate)]
    [InlineData(2000)]
    public async Task A_datagram_is_a_packet(double rate)
    {
        using Socket receiver = Receiver();
        BroadcasterOptions options = Options(rate, receiver);
        await using Broadcaster broadcaster = Started(options);
        var packets = new List<byte[]>();
        for (int i = 0; i < 10 * 2 * 2; i++)
            packets.Add(await ReceiveAsync(receiver));

        Expect.Frames(packets, options, 10);
        await broadcaster.Completion.Soon();
        Assert.Null(broadcaster.LocalEndPoint);
        Assert.Equal(20, broadcaster.GetStatistics().FramesSent);
        Assert.Equal(packets.Sum(packet => packet.Length), broadcaster.GetStatistics().BytesSent);
        Assert.Equal(0, broadcaster.GetStatistics().Clients);
    }

    [Fact]
    public async Task A_packet_can_be_cut_as_on_macos_and_never_shares_a_datagram()
    {
        using Socket receiver = Receiver();
        BroadcasterOptions options = Options(BroadcasterOptions.MaxFrameRate, receiver);
        options.Fragment = 1024;
        await using Broadcaster broadcaster = Started(options);
        var packets = new List<byte[]>();
        for (int i = 0; i < 10 * 2; i++)
        {
            packets.Add(await JoinAsync(receiver, 1024, 456));
            packets.Add(await JoinAsync(receiver, 1024, 1024, 1024, 776));
        }

        Expect.Frames(packets, options, 10);
    }

    [Fact]
    public async Task Tcp_clients_and_several_destinations_get_the_same()
    {
        using Socket receiver = Receiver();
        using Socket other = Receiver();
        BroadcasterOptions options = Options(2000, receiver);
        options.UdpDestinations = [(IPEndPoint)receiver.LocalEndPoint!, (IPEndPoint)other.LocalEndPoint!];
        options.Port = 0;
        options.WaitForClient = true;
        await using Broadcaster broadcaster = Started(options);
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        List<byte[]> stream = await client.ReadToEndAsync();

        Expect.Frames(stream, options, 10);
        foreach (byte[] packet in stream)
        {
            Assert.Equal(packet, await ReceiveAsync(receiver));
            Assert.Equal(packet, await ReceiveAsync(other));
        }
    }

    [Fact]
    public async Task Later_changes_of_an_end_point_have_no_effect()
    {
        using Socket receiver = Receiver();
        var destination = (IPEndPoint)receiver.LocalEndPoint!;
        int port = destination.Port;
        BroadcasterOptions options = Options(2000, destination);
        options.MaxFrames = null;
        await using var broadcaster = new Broadcaster(options);
        destination.Port = 1;
        broadcaster.Start();
        await ReceiveAsync(receiver);

        var reported = (IPEndPoint)Assert.Single(broadcaster.GetClients()).RemoteEndPoint!;
        Assert.Equal(port, reported.Port);
        reported.Port = 1;
        Assert.Equal(new IPEndPoint(IPAddress.Loopback, port), Assert.Single(broadcaster.GetClients()).RemoteEndPoint);
    }

    [Fact]
    public async Task An_unreachable_destination_does_not_end_the_broadcast()
    {
        BroadcasterOptions options = Options(BroadcasterOptions.MaxFrameRate, new IPEndPoint(IPAddress.Loopback, FreePort.Next()));
        options.MaxFrames = 2000;
        await using Broadcaster broadcaster = Started(options);
        await broadcaster.Completion.Soon();
        BroadcasterStatistics statistics = broadcaster.GetStatistics();
        Assert.Equal(2000 * 2 * 2, CountPackets(statistics));
    }

    [Fact]
    public async Task A_broadcast_without_end_can_be_stopped()
    {
        using Socket receiver = Receiver();
        BroadcasterOptions options = Options(BroadcasterOptions.MaxFrameRate, receiver);
        options.MaxFrames = null;
        Broadcaster broadcaster = Started(options);
        await ReceiveAsync(receiver);
        await broadcaster.DisposeAsync().AsTask().Soon();
        await broadcaster.Completion.Soon();
    }

    private static BroadcasterOptions Options(double rate, Socket receiver) => Options(rate, (IPEndPoint)receiver.LocalEndPoint!);

    private static BroadcasterOptions Options(double rate, IPEndPoint destination)
    {
        BroadcasterOptions options = Expect.Options(avatars: 2);
        options.FrameRate = rate;
        options.Port = null;
        options.UdpDestinations = [destination];
        options.Calculation = TestSource.WriteCalculation;
        options.MaxFrames = 10;
        return options;
    }

    private static async Task<byte[]> ReceiveAsync(Socket socket)
    {
        byte[] buffer = new byte[65_536];
        int count = await socket.ReceiveAsync(buffer.AsMemory(), TestContext.Current.CancellationToken).Soon();
        return buffer[..count];
    }

    private static async Task<byte[]> JoinAsync(Socket socket, params int[] sizes)
    {
        var packet = new List<byte>();
        foreach (int size in sizes)
        {
            byte[] datagram = await ReceiveAsync(socket);
            Assert.Equal(size, datagram.Length);
            packet.AddRange(datagram);
        }

        return [.. packet];
    }

    // Motion packets are 1480 bytes, calculation packets 3848.
    private static long CountPackets(BroadcasterStatistics statistics)
    {
        long calculationPackets = (statistics.BytesSent - (statistics.FramesSent * 1480)) / 3848;
        return statistics.FramesSent + calculationPackets + statistics.PacketsDropped;
    }
}
