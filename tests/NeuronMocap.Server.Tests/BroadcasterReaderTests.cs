using System.Net;
using System.Net.Sockets;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Server;

namespace NeuronMocap.Server.Tests;

// A broadcaster that sends on what a reader receives.
public sealed class BroadcasterReaderTests
{
    public static TheoryData<string, Splitting> Streams
    {
        get
        {
            var data = new TheoryData<string, Splitting>();
            foreach (string name in WrittenStreams.Names.Select(static row => row.Data))
            {
                data.Add(name, Splitting.Whole);
                data.Add(name, Splitting.ByteByByte);
                data.Add(name, Splitting.PiecesOf1024);
            }

            return data;
        }
    }

    [Theory]
    [MemberData(nameof(Streams))]
    public async Task Every_byte_goes_out_as_it_came(string name, Splitting splitting)
    {
        byte[] bytes = StreamFixture.Load(name).Bytes;
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        await using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0, CloseTimeout = Limits.Unexpected });
        using Socket first = await ConnectAsync(broadcaster, clients: 1);
        using Socket second = await ConnectAsync(broadcaster, clients: 2);
        reader.Start();
        using TestConnection source = await server.AcceptAsync();
        foreach (ArraySegment<byte> piece in Splits.Of(bytes, splitting).Single())
            await source.SendAsync(piece);

        source.Close();
        byte[][] received = await Task.WhenAll(ReadToEndAsync(first), ReadToEndAsync(second)).Soon();
        Assert.Equal(bytes, received[0]);
        Assert.Equal(bytes, received[1]);
        first.Dispose();
        second.Dispose();
        await broadcaster.Completion.Soon();
        Assert.Equal((0, 0), (broadcaster.GetStatistics().PacketsDropped, broadcaster.GetStatistics().IncompletePackets));
    }

    [Fact]
    public async Task Clients_stay_while_the_reader_loses_and_regains_its_server()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options(reconnect: true));
        await using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0 });
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: false);
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 1);
        reader.Start();
        using (TestConnection source = await server.AcceptAsync())
        {
            await source.SendAsync((byte[])[.. TestPackets.Motion(0), .. TestPackets.Motion(1)[..700]]);
            source.Close();
        }

        using TestConnection again = await server.AcceptAsync();
        await again.SendAsync(TestPackets.Motion(2));
        Assert.Equal(TestPackets.Motion(0), await client.ReadAsync());
        Assert.Equal(TestPackets.Motion(2), await client.ReadAsync());
        Assert.Equal((1, 1), (broadcaster.GetStatistics().IncompletePackets, broadcaster.GetStatistics().Accepted));
        await reader.DisposeAsync();
        Assert.Null(await client.ReadAsync());
        client.Dispose();
        await broadcaster.Completion.Soon();
    }

    [Fact]
    public async Task A_client_that_never_reads_costs_the_others_nothing()
    {
        const int Others = 9;
        const int Batch = 64;
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        await using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0 });
        using var idle = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp) { ReceiveBufferSize = 4096 };
        await idle.ConnectAsync(broadcaster.LocalEndPoint!, TestContext.Current.CancellationToken).AsTask().Soon();
        EndPoint idleEndPoint = idle.LocalEndPoint!;
        TestClient[] clients = await Task.WhenAll(Enumerable.Range(0, Others).Select(_ => TestClient.ConnectAsync(broadcaster.LocalEndPoint)));
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == Others + 1);
        reader.Start();
        using TestConnection source = await server.AcceptAsync();
        int sent = 0;
        while (DroppedOf(idleEndPoint) == 0)
        {
            byte[][] batch = [.. Enumerable.Range(sent, Batch).Select(static index => TestPackets.Motion(index))];
            await source.SendAsync(batch.SelectMany(static packet => packet).ToArray());
            await Task.WhenAll(clients.Select(async client =>
            {
                foreach (byte[] packet in batch)
                    Assert.Equal(packet, await client.ReadAsync());
            })).Soon();
            sent += Batch;
        }

        Assert.All(broadcaster.GetClients().Where(client => !idleEndPoint.Equals(client.RemoteEndPoint)), static client => Assert.Equal(0, client.PacketsDropped));
        foreach (TestClient client in clients)
            client.Dispose();

        long DroppedOf(EndPoint endPoint) => broadcaster.GetClients().Single(client => endPoint.Equals(client.RemoteEndPoint)).PacketsDropped;
    }

    [Fact]
    public async Task Over_udp_two_senders_never_mix_inside_a_packet()
    {
        await using UdpEnd end = await UdpEnd.StartAsync();
        using Socket receiver = Broadcasts.Receiver();
        await using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions
        {
            Reader = end.Reader,
            Port = null,
            UdpDestinations = [(IPEndPoint)receiver.LocalEndPoint!],
        });
        Socket[] senders = [end.CreateSender(), end.CreateSender()];
        for (int frame = 0; frame < 20; frame++)
        {
            for (int half = 0; half < 2; half++)
            {
                for (int i = 0; i < senders.Length; i++)
                    await end.SendAsync(senders[i], PacketOf(i, frame).AsMemory(half == 0 ? ..1024 : 1024..));
            }
        }

        var byAvatar = new List<byte[]>[] { [], [] };
        byte[] buffer = new byte[65_536];
        while (byAvatar.Sum(static packets => packets.Count) < 40)
        {
            int count = await receiver.ReceiveAsync(buffer.AsMemory(), SocketFlags.None, TestContext.Current.CancellationToken).Soon();
            Assert.True(MotionHeader.TryRead(buffer, out MotionHeader header));
            byAvatar[header.AvatarIndex].Add(buffer[..count]);
        }

        for (int i = 0; i < 2; i++)
            Assert.Equal(Enumerable.Range(0, 20).Select(frame => PacketOf(i, frame)), byAvatar[i]);

        static byte[] PacketOf(int avatar, int frame) => TestPackets.Motion(frame, avatar: avatar);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task The_receive_thread_allocates_nothing(bool isDatagrams)
    {
        await using var reader = new NeuronReader("127.0.0.1");
        await using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0, QueueCapacity = 8 });
        byte[] sender = isDatagrams ? [2, 0, 27, 89, 127, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0] : [];
        byte[] packet = TestPackets.Motion(0);
        long now = 0;
        reader.Tap.Open(isDatagrams, local: null, remote: null, now);
        Allocations.AssertNone(() => reader.Tap.OnBytes(0, sender, packet, ++now));
        reader.Tap.Close("test", now);
        Assert.Equal(0, broadcaster.GetStatistics().IncompletePackets);
    }

    [Fact]
    public async Task A_stopped_broadcaster_leaves_the_reader_running()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        reader.Start();
        using TestConnection source = await server.AcceptAsync();
        await using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0 });
        Assert.True(reader.Tap.IsListened);
        broadcaster.Stop();
        await broadcaster.Completion.Soon();
        Assert.False(reader.Tap.IsListened);
        await source.SendAsync(TestPackets.Motion(0));
        await reader.WaitForFramesAsync(1);
    }

    [Fact]
    public async Task A_reader_that_never_started_ends_the_broadcast_when_it_is_disposed()
    {
        await using var reader = new NeuronReader("127.0.0.1");
        await using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0 });
        await reader.DisposeAsync();
        await broadcaster.Completion.Soon();
    }

    [Fact]
    public async Task A_client_that_comes_late_starts_at_a_packet()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        await using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0 });
        reader.Start();
        using TestConnection source = await server.AcceptAsync();
        await source.SendAsync((byte[])[.. TestPackets.Motion(0), .. TestPackets.Motion(1)[..100]]);
        await reader.WaitForFramesAsync(1);
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 1);
        await source.SendAsync(TestPackets.Motion(1).AsMemory(100));
        Assert.Equal(TestPackets.Motion(1), await client.ReadAsync());
    }

    [Fact]
    public async Task Calculation_packets_can_have_their_own_port()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        await using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0, CalculationPort = 0 });
        using TestClient motion = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        using TestClient calculation = await TestClient.ConnectAsync(broadcaster.CalculationEndPoint);
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 2);
        reader.Start();
        using TestConnection source = await server.AcceptAsync();
        await source.SendAsync((byte[])[.. TestPackets.Motion(0), .. TestPackets.Calculation(0)]);
        source.Close();
        Assert.Equal([TestPackets.Motion(0)], await motion.ReadToEndAsync());
        Assert.Equal([TestPackets.Calculation(0)], await calculation.ReadToEndAsync());
    }

    [Fact]
    public async Task Meaningless_settings_are_refused_by_name()
    {
        await using var reader = new NeuronReader("127.0.0.1");
        AssertRefused(nameof(BroadcasterOptions.Sources), options => options.Sources = [new TestSource()]);
        AssertRefused(nameof(BroadcasterOptions.RecordingPath), options => options.RecordingPath = "take.nmrec");
        AssertRefused(nameof(BroadcasterOptions.FrameRate), options => options.FrameRate = 60);
        AssertRefused(nameof(BroadcasterOptions.RecordingSpeed), options => options.RecordingSpeed = 2);
        AssertRefused(nameof(BroadcasterOptions.LoopRecording), options => options.LoopRecording = true);
        AssertRefused(nameof(BroadcasterOptions.Format), options => options.Format = BroadcastFormat.Text);
        using var broadcaster = new Broadcaster(new BroadcasterOptions { Reader = reader, Port = 0 });
        Assert.Throws<ArgumentException>(() => new CommandServer(broadcaster));
        Assert.Equal((0, false), (broadcaster.FrameRate, broadcaster.ZeroOut(0)));

        void AssertRefused(string setting, Action<BroadcasterOptions> set)
        {
            var options = new BroadcasterOptions { Reader = reader, Port = 0 };
            set(options);
            Assert.Contains($"BroadcasterOptions.{setting} ", Assert.Throws<ArgumentException>(() => new Broadcaster(options)).Message, StringComparison.Ordinal);
        }
    }

    private static async Task<Socket> ConnectAsync(Broadcaster broadcaster, int clients)
    {
        var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        await socket.ConnectAsync(broadcaster.LocalEndPoint!, TestContext.Current.CancellationToken).AsTask().Soon();
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == clients);
        return socket;
    }

    private static async Task<byte[]> ReadToEndAsync(Socket socket)
    {
        using var bytes = new MemoryStream();
        await using var stream = new NetworkStream(socket);
        await stream.CopyToAsync(bytes, TestContext.Current.CancellationToken);
        return bytes.ToArray();
    }
}
