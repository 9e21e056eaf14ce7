using System.Net;
using System.Net.Sockets;
using System.Runtime.InteropServices;
using NeuronMocap.Protocol;
using NeuronMocap.Server.Clients;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Server.Tests;

// Clients of a relay to which the receive thread sends, and those that fall behind. The tests are the receive thread.
public sealed class BroadcasterReaderDirectTests
{
    private const int Batch = 32;

    [Fact]
    public async Task A_client_that_keeps_up_is_served_on_the_receive_thread_without_memory()
    {
        if (!DirectSending.IsSupported)
            Assert.Skip("This build of the library sends on the threads of the clients.");

        await using var reader = new NeuronReader("127.0.0.1");
        await using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0 });
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 1);
        byte[] packet = TestPackets.Motion(0);
        long now = 0;
        reader.Tap.Open(isDatagrams: false, local: null, remote: null, now);

        // Its own thread may still be busy with an earlier packet. Once that thread waits, each packet is sent before the call returns.
        long sent = 0;
        await Limits.UntilAsync(() =>
        {
            Push();
            return broadcaster.GetStatistics().FramesSent == sent;
        });
        Allocations.AssertNone(Push);
        Assert.Equal((sent, 0), (broadcaster.GetStatistics().FramesSent, broadcaster.GetStatistics().PacketsDropped));

        void Push()
        {
            reader.Tap.OnBytes(0, [], packet, ++now);
            sent++;
            while (client.Socket.Available >= packet.Length)
                client.Socket.Receive(packet);
        }
    }

    [Fact]
    public async Task A_udp_destination_is_served_on_the_receive_thread_and_one_that_nobody_opened_loses_only_its_own()
    {
        if (!DirectSending.IsSupported)
            Assert.Skip("This build of the library sends on the threads of the clients.");

        await using var reader = new NeuronReader("127.0.0.1");
        using Socket receiver = Broadcasts.Receiver();
        var nobody = new IPEndPoint(IPAddress.Loopback, FreePort.Next());
        var somebody = (IPEndPoint)receiver.LocalEndPoint!;
        await using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = null, UdpDestinations = [nobody, somebody] });
        reader.Tap.Open(isDatagrams: false, local: null, remote: null, 0);
        byte[] buffer = new byte[65_536];
        byte[] packet = TestPackets.Motion(0);
        for (int index = 0; index < 100; index++)
        {
            reader.Tap.OnBytes(0, [], (byte[])[.. TestPackets.Motion(2 * index), .. TestPackets.Motion((2 * index) + 1)], index);
            for (int half = 0; half < 2; half++)
            {
                int count = await receiver.ReceiveAsync(buffer.AsMemory(), SocketFlags.None, TestContext.Current.CancellationToken).Soon();
                Assert.Equal(TestPackets.Motion((2 * index) + half), buffer[..count]);
            }
        }

        await Limits.UntilAsync(() => Sent() == 200);
        await Limits.UntilAsync(() =>
        {
            long before = Sent();
            Push();
            return Sent() == before + 1;
        });
        Allocations.AssertNone(Push);

        void Push()
        {
            reader.Tap.OnBytes(0, [], packet, 1000);
            while (receiver.Available > 0)
                receiver.Receive(buffer);
        }

        long Sent() => broadcaster.GetClients().Single(client => somebody.Equals(client.RemoteEndPoint)).FramesSent;
    }

    // The client stalls and catches up again and again, so that its packets go in turn through the receive thread and through its own thread.
    [Fact]
    public async Task A_client_that_stalls_gets_whole_packets_in_order_and_every_loss_is_counted()
    {
        const int Rounds = 3;
        await using var reader = new NeuronReader("127.0.0.1");
        await using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0, QueueCapacity = 64, CloseTimeout = Limits.Unexpected });
        using Socket client = new(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp) { ReceiveBufferSize = 4096 };
        await client.ConnectAsync(broadcaster.LocalEndPoint!, TestContext.Current.CancellationToken).AsTask().Soon();
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 1);
        reader.Tap.Open(isDatagrams: false, local: null, remote: null, 0);
        var random = new Random(1);
        var received = new List<byte>();
        byte[] buffer = new byte[1 << 20];
        int pushed = 0;
        for (int round = 0; round < Rounds; round++)
        {
            long dropped = broadcaster.GetStatistics().PacketsDropped;
            while (broadcaster.GetStatistics().PacketsDropped == dropped)
                Push(2 * Batch);

            await CatchUpAsync();
            for (int i = 0; i < 20; i++)
            {
                Push(4);
                await CatchUpAsync();
            }
        }

        await reader.DisposeAsync();
        for (int count = 1; count > 0; received.AddRange(buffer[..count]))
            count = await client.ReceiveAsync(buffer.AsMemory(), TestContext.Current.CancellationToken).Soon();

        client.Dispose();
        await broadcaster.Completion.Soon();
        List<int> indices = ReadIndices(CollectionsMarshal.AsSpan(received));
        Assert.Equal(indices.Distinct().Order(), indices);
        Assert.Equal(pushed - 1, indices[^1]);
        BroadcasterStatistics statistics = broadcaster.GetStatistics();
        Assert.Equal((indices.Count, pushed - indices.Count, received.Count), (statistics.FramesSent, statistics.PacketsDropped, statistics.BytesSent));

        void Push(int most)
        {
            byte[] piece = [.. Enumerable.Range(0, random.Next(1, most)).SelectMany(_ => TestPackets.Motion(pushed++))];
            reader.Tap.OnBytes(0, [], piece, pushed);
        }

        async Task CatchUpAsync()
        {
            while (client.Available > 0 || broadcaster.GetStatistics() is var now && now.FramesSent + now.PacketsDropped < pushed)
            {
                if (client.Available > 0)
                    received.AddRange(buffer[..client.Receive(buffer)]);
                else
                    await Task.Delay(1, TestContext.Current.CancellationToken);
            }
        }
    }

    // A relay whose server sends nothing. Only sending would show that a client has left.
    [Fact]
    public async Task Clients_that_have_left_give_way_while_no_frames_come()
    {
        await using var reader = new NeuronReader("127.0.0.1");
        await using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0, MaxClients = 2 });
        for (int i = 0; i < 2; i++)
        {
            TestClient gone = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
            await Limits.UntilAsync(() => broadcaster.GetStatistics().Accepted == i + 1);
            gone.Dispose();
        }

        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        await Limits.UntilAsync(() => broadcaster.GetStatistics() is { Accepted: 3, Clients: <= 2 });
        Assert.Equal(0, broadcaster.GetStatistics().Refused);
        reader.Tap.Open(isDatagrams: false, local: null, remote: null, 0);
        reader.Tap.OnBytes(0, [], TestPackets.Motion(0), 1);
        Assert.Equal(TestPackets.Motion(0), await client.ReadAsync());
    }

    [Fact]
    public async Task Several_broadcasters_of_a_reader_come_and_go_independently()
    {
        await using var reader = new NeuronReader("127.0.0.1");
        reader.Tap.Open(isDatagrams: false, local: null, remote: null, 0);
        await using Broadcaster first = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0 });
        using TestClient ofFirst = await ConnectAsync(first);
        reader.Tap.OnBytes(0, [], TestPackets.Motion(0)[..100], 1);

        // The second one comes in the middle of a packet, which is not its first: the cut is that of the first one.
        await using Broadcaster second = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0 });
        using TestClient ofSecond = await ConnectAsync(second);
        reader.Tap.OnBytes(0, [], TestPackets.Motion(0)[100..], 2);
        Assert.Equal(TestPackets.Motion(0), await ofFirst.ReadAsync());
        Assert.Equal(TestPackets.Motion(0), await ofSecond.ReadAsync());
        reader.Tap.OnBytes(0, [], TestPackets.Motion(1)[..100], 3);
        reader.Tap.Close("test", 4);
        Assert.Equal((1, 1), (first.GetStatistics().IncompletePackets, second.GetStatistics().IncompletePackets));

        first.Stop();
        Assert.True(reader.Tap.IsListened);
        reader.Tap.Open(isDatagrams: false, local: null, remote: null, 5);
        reader.Tap.OnBytes(0, [], TestPackets.Motion(2), 6);
        Assert.Equal(TestPackets.Motion(2), await ofSecond.ReadAsync());
        second.Stop();
        Assert.False(reader.Tap.IsListened);

        await using Broadcaster third = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0 });
        using TestClient ofThird = await ConnectAsync(third);
        reader.Tap.OnBytes(0, [], TestPackets.Motion(3), 7);
        Assert.Equal(TestPackets.Motion(3), await ofThird.ReadAsync());
        Assert.Equal(0, third.GetStatistics().IncompletePackets);
        Assert.Equal(1, first.GetStatistics().IncompletePackets);

        static async Task<TestClient> ConnectAsync(Broadcaster broadcaster)
        {
            TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
            await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 1);
            return client;
        }
    }

    // It reads nothing, so the writes of its own thread wait. They end with the connection.
    [Fact]
    public async Task A_client_that_never_reads_is_disconnected_after_the_timeout()
    {
        await using var reader = new NeuronReader("127.0.0.1");
        await using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0, ClientTimeout = TimeSpan.FromSeconds(1) });
        using var idle = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp) { ReceiveBufferSize = 4096 };
        await idle.ConnectAsync(broadcaster.LocalEndPoint!, TestContext.Current.CancellationToken).AsTask().Soon();
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 1);
        reader.Tap.Open(isDatagrams: false, local: null, remote: null, 0);
        byte[] piece = [.. Enumerable.Range(0, Batch).SelectMany(static index => TestPackets.Motion(index))];

        // These pieces are more than the connection and the queue hold. The client times out only later.
        for (int i = 0; i < 64; i++)
            reader.Tap.OnBytes(0, [], piece, 1);

        await Limits.UntilAsync(() =>
        {
            reader.Tap.OnBytes(0, [], piece, 1);
            return broadcaster.GetStatistics().Clients == 0;
        });
        Assert.True(broadcaster.GetStatistics().PacketsDropped > 0);
    }

    [Fact]
    public async Task A_stop_ends_a_write_that_waits()
    {
        await using var reader = new NeuronReader("127.0.0.1");
        Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0, ClientTimeout = Timeout.InfiniteTimeSpan });
        using var idle = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp) { ReceiveBufferSize = 4096 };
        await idle.ConnectAsync(broadcaster.LocalEndPoint!, TestContext.Current.CancellationToken).AsTask().Soon();
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 1);
        reader.Tap.Open(isDatagrams: false, local: null, remote: null, 0);
        byte[] piece = [.. Enumerable.Range(0, Batch).SelectMany(static index => TestPackets.Motion(index))];
        await Limits.UntilAsync(() =>
        {
            reader.Tap.OnBytes(0, [], piece, 1);
            return broadcaster.GetStatistics().PacketsDropped > 0;
        });
        broadcaster.Stop();
        await broadcaster.Completion.Soon();
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 0);
    }

    private static List<int> ReadIndices(ReadOnlySpan<byte> packets)
    {
        var indices = new List<int>();
        var scanner = new PacketScanner();
        while (!packets.IsEmpty)
        {
            ScanResult result = scanner.Scan(packets);
            Assert.Equal(ScanStatus.Packet, result.Status);
            Assert.True(MotionHeader.TryRead(packets, out MotionHeader header));
            indices.Add((int)header.FrameIndex!.Value);
            Assert.Equal(TestPackets.Motion(indices[^1]), packets[..result.Length].ToArray());
            packets = packets[result.Length..];
        }

        return indices;
    }
}
