using System.Net;
using System.Net.Sockets;
using NeuronMocap.Tests.Diagnostics;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

public sealed class UdpReaderTests
{
    [Theory]
    [InlineData(1480)]
    [InlineData(1024)]
    [InlineData(100)]
    public async Task Frames_cut_into_datagrams_are_joined(int datagramSize)
    {
        await using NeuronReader reader = await StartAsync();
        using FrameQueue queue = reader.OpenQueue();
        using Socket sender = Sender(reader);
        for (int i = 0; i < 50; i++)
        {
            Send(sender, TestPackets.Motion(i), datagramSize);

            // One frame at a time, so that no socket buffer of any system can overflow.
            await reader.WaitForFramesAsync(i + 1);
        }

        List<uint?> indices = [];
        queue.Pump<MotionFrame>(frame =>
        {
            indices.Add(frame.FrameIndex);
            Assert.Equal(TestPackets.Value((int)frame.FrameIndex!, 0, 353), frame.Values[353]);
        });
        Assert.Equal(Enumerable.Range(0, 50).Select(i => (uint?)i), indices);
        Assert.Equal((0L, 0L), (reader.GetStatistics().Lost, reader.GetStatistics().BytesSkipped));
    }

    [Fact]
    public async Task Two_senders_of_the_same_avatar_are_distinguished()
    {
        await using NeuronReader reader = await StartAsync();
        using FrameQueue queue = reader.OpenQueue();
        using Socket first = Sender(reader);
        using Socket second = Sender(reader);
        byte[] one = TestPackets.Motion(10);
        byte[] two = TestPackets.Motion(500);
        first.Send(one.AsSpan(0, 1024));
        second.Send(two.AsSpan(0, 1024));
        second.Send(two.AsSpan(1024));
        first.Send(one.AsSpan(1024));
        await reader.WaitForFramesAsync(2);

        List<(uint?, int)> seen = [];
        queue.Pump<MotionFrame>(frame => seen.Add((frame.FrameIndex, frame.Sender)));
        Assert.Equal([(500u, 1), (10u, 0)], seen);
        Assert.Equal(0, reader.GetStatistics().Lost);
        Assert.Equal(2, reader.GetAvatarStatistics().Count);
    }

    [Fact]
    public async Task A_port_in_use_is_reported()
    {
        using var other = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        other.Bind(new IPEndPoint(IPAddress.Any, 0));
        int port = ((IPEndPoint)other.LocalEndPoint!).Port;
        await using var reader = new NeuronReader(new NeuronReaderOptions { Transport = TransportKind.Udp, Port = port, Reconnect = { Enabled = false } });
        NeuronConnectionException exception = await Assert.ThrowsAsync<NeuronConnectionException>(() => reader.StartAsync().Soon());
        Assert.Equal(ConnectionReason.PortInUse, exception.Reason);
        Assert.Contains($"{port}", exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_status_shows_the_granted_receive_buffer()
    {
        await using NeuronReader reader = await StartAsync();
        using var other = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp) { ReceiveBufferSize = 4 * 1024 * 1024 };

        // Linux reports twice the granted size, which Mono halves.
        Assert.Equal(OperatingSystem.IsLinux() && !Runtimes.IsMono ? other.ReceiveBufferSize / 2 : other.ReceiveBufferSize, reader.Status.ReceiveBufferSize);
        if (File.Exists("/proc/sys/net/core/rmem_max"))
        {
            int limit = int.Parse(await File.ReadAllTextAsync("/proc/sys/net/core/rmem_max", TestContext.Current.CancellationToken), provider: null);
            Assert.Equal(Math.Min(limit, 4 * 1024 * 1024), reader.Status.ReceiveBufferSize);
        }

        using ScriptedServer server = ScriptedServer.Streaming();
        await using var overTcp = new NeuronReader("127.0.0.1", server.Port);
        await overTcp.StartAsync(TestContext.Current.CancellationToken);
        Assert.Null(overTcp.Status.ReceiveBufferSize);
    }

    [Fact]
    public async Task Two_readers_can_share_a_port_when_both_ask_for_it()
    {
        await using NeuronReader first = await StartAsync(share: true);
        int port = ((IPEndPoint)first.Status.LocalEndPoint!).Port;
        await using NeuronReader second = await StartAsync(share: true, port);
        Assert.True(second.Status.IsConnected);
    }

    [Fact]
    public async Task Empty_and_huge_datagrams_are_harmless()
    {
        await using NeuronReader reader = await StartAsync();
        using Socket sender = Sender(reader);
        sender.Send(ReadOnlySpan<byte>.Empty);
        sender.Send(new byte[60_000]);
        sender.Send(TestPackets.Motions(0, 40));
        await reader.WaitForFramesAsync(40);
        Assert.Equal(60_000, reader.GetStatistics().BytesSkipped);
    }

    private static async Task<NeuronReader> StartAsync(bool share = false, int port = 0)
    {
        var reader = new NeuronReader(new NeuronReaderOptions
        {
            Transport = TransportKind.Udp,
            LocalAddress = IPAddress.Loopback,
            Port = port,
            SharePort = share,
            Reconnect = { Enabled = false },
        });
        await reader.StartAsync().Soon();
        return reader;
    }

    private static Socket Sender(NeuronReader reader)
    {
        var sender = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        sender.Connect(reader.Status.LocalEndPoint!);
        return sender;
    }

    private static void Send(Socket sender, byte[] packet, int size)
    {
        foreach (byte[] datagram in packet.Chunk(size))
            sender.Send(datagram);
    }
}
