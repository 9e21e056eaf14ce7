using System.Net;
using System.Net.Sockets;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Server.Tests.Osc;

public sealed class VmcSourceTests
{
    [Fact]
    public async Task A_reader_receives_what_another_program_sends()
    {
        var source = new VmcSource(0, IPAddress.Loopback, "Bob");
        await using var receiving = new NeuronReader(new NeuronReaderOptions { Source = source, SilenceTimeout = Limits.Unexpected });
        using FrameQueue frames = receiving.OpenQueue();
        await receiving.StartAsync().Soon();

        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        await using var sender = new VmcSender(reader, new VmcSenderOptions { Port = source.LocalEndPoint!.Port, MaxRate = 0 });
        sender.Start();
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();
        for (int i = 0; i < 20; i++)
        {
            MotionFrame sent = Poses.Frame(i);
            await connection.SendAsync(sent.Packet.ToArray());
            Assert.True(await frames.WaitAsync(TestContext.Current.CancellationToken).Soon());
            int taken = frames.Pump<MotionFrame>(frame =>
            {
                Assert.Equal("Bob", frame.AvatarName);
                Poses.AssertSame(Poses.World(sent)[(int)Bone.Head], Poses.World(frame)[(int)Bone.Head], 0.05f, "Head");
            });
            Assert.Equal(1, taken);
        }

        Assert.Equal((0, 0), (source.Rejected, receiving.GetStatistics().BytesSkipped));
    }

    [Fact]
    public async Task Garbage_is_counted_and_the_stream_continues()
    {
        var source = new VmcSource(0, IPAddress.Loopback);
        await using var reader = new NeuronReader(new NeuronReaderOptions { Source = source, SilenceTimeout = Limits.Unexpected });
        using FrameQueue frames = reader.OpenQueue();
        await reader.StartAsync().Soon();
        using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        socket.Connect(source.LocalEndPoint!);
        socket.Send("GET / HTTP/1.1"u8);
        socket.Send(ReadOnlySpan<byte>.Empty);
        foreach (byte[] datagram in Poses.Encode(new NeuronMocap.Server.Osc.VmcEncoder(1, false, 0), Poses.Taken(Poses.Frame())))
            socket.Send(datagram);

        Assert.True(await frames.WaitAsync(TestContext.Current.CancellationToken).Soon());
        Assert.Equal((2, 2), (source.Rejected, reader.GetStatistics().RejectedMessages));
    }

    [Fact]
    public async Task A_port_in_use_is_the_reason_and_stopping_frees_the_port()
    {
        var first = new VmcSource(0, IPAddress.Loopback);
        var reader = new NeuronReader(new NeuronReaderOptions { Source = first });
        await reader.StartAsync().Soon();
        int port = first.LocalEndPoint!.Port;
        await using (var second = new NeuronReader(new NeuronReaderOptions { Source = new VmcSource(port, IPAddress.Loopback), Reconnect = { Enabled = false } }))
        {
            NeuronConnectionException fault = await Assert.ThrowsAsync<NeuronConnectionException>(() => second.StartAsync().Soon());
            Assert.Equal(ConnectionReason.PortInUse, fault.Reason);
            Assert.Contains($"VMC port {port}", fault.Message, StringComparison.Ordinal);
        }

        await reader.DisposeAsync().AsTask().Soon();
        await using var third = new NeuronReader(new NeuronReaderOptions { Source = new VmcSource(port, IPAddress.Loopback), Reconnect = { InitialDelay = TimeSpan.FromMilliseconds(1), MaxDelay = TimeSpan.FromMilliseconds(5) } });
        third.Start();
        await Limits.UntilAsync(() => third.Status.State is ConnectionState.Connected or ConnectionState.Receiving or ConnectionState.Silent);
    }

    [Fact]
    public async Task An_address_of_another_computer_is_said()
    {
        // An address that documents may use, and no computer has.
        var source = new VmcSource(39539, IPAddress.Parse("192.0.2.1"));
        Assert.Equal("VMC port 39539 of 192.0.2.1", source.Name);
        Assert.Equal("VMC port 39539", new VmcSource().Name);
        await using var reader = new NeuronReader(new NeuronReaderOptions { Source = source, Reconnect = { Enabled = false } });
        NeuronConnectionException fault = await Assert.ThrowsAsync<NeuronConnectionException>(() => reader.StartAsync().Soon());
        Assert.Equal(ConnectionReason.AddressUnavailable, fault.Reason);
        Assert.Contains("192.0.2.1 is not an address of this computer. A source receives on one of this computer's own addresses", fault.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_port_out_of_range_is_refused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => new VmcSource(-1));
        Assert.Throws<ArgumentOutOfRangeException>(() => new VmcSource(65_536));
        Assert.Throws<ArgumentNullException>(() => new VmcSource(avatarName: null!));
    }
}
