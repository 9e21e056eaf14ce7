using System.Net;
using System.Net.Sockets;
using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Reader;

public sealed partial class ReceiveThreadTests
{
    private static readonly NeuronReaderOptions Udp = new()
    {
        Transport = TransportKind.Udp,
        LocalAddress = IPAddress.Loopback,
        Port = 0,
        ReceiveThread = ReceiveThread.Dedicated,
    };

    // Other tests may have taken all threads.
    [Fact]
    public async Task A_udp_port_gets_a_thread_while_some_are_left()
    {
        await using UdpEnd end = await UdpEnd.StartAsync();
        bool? isPooled = null;
        end.Reader.MotionReceived += _ => isPooled = Thread.CurrentThread.IsThreadPoolThread;
        await end.SendAsync(end.CreateSender(), TestPackets.Motion(1));
        await end.Reader.WaitForFramesAsync(1);
        Assert.Equal(isPooled == true ? ReceiveThread.Pool : ReceiveThread.Dedicated, end.Reader.Status.ReceiveThread);
    }

    [Fact]
    public void A_closed_udp_port_returns_its_thread()
    {
        var threads = new ReceiveThreads(limit: 1);
        for (int i = 0; i < 3; i++)
        {
            using var link = new UdpLink(new LinkOptions("127.0.0.1", 0), new SenderFilter([]), threads: threads);
            Assert.Equal(ReceiveThread.Dedicated, link.ReceiveThread);
            using var other = new UdpLink(new LinkOptions("127.0.0.1", 0), new SenderFilter([]), threads: threads);
            Assert.Equal(ReceiveThread.Pool, other.ReceiveThread);
            link.Close();
        }

        Assert.True(threads.TryTake(ReceiveThread.Auto));
    }

    [Fact]
    public async Task A_udp_port_gets_a_thread_on_request()
    {
        await using var reader = new NeuronReader(Udp);
        bool? isPooled = null;
        reader.MotionReceived += _ => isPooled = Thread.CurrentThread.IsThreadPoolThread;
        await reader.StartAsync().Soon();
        Assert.Equal(ReceiveThread.Dedicated, reader.Status.ReceiveThread);
        using var sender = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        await sender.SendToAsync(TestPackets.Motion(1), reader.Status.LocalEndPoint!);
        await reader.WaitForFramesAsync(1);
        Assert.False(isPooled);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    public async Task A_udp_port_with_a_thread_closes_at_once(int frames)
    {
        for (int i = 0; i < 20; i++)
        {
            var reader = new NeuronReader(Udp);
            await reader.StartAsync().Soon();
            var end = (IPEndPoint)reader.Status.LocalEndPoint!;
            using var sender = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
            if (frames > 0)
                await sender.SendToAsync(TestPackets.Motion(1), end);

            await reader.WaitForFramesAsync(frames);
            await reader.DisposeAsync();
            Assert.True(reader.Completion.IsCompleted);

            // The port is free again.
            using var next = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
            next.Bind(end);
        }
    }
}
