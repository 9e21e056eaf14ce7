using System.Text;
using NeuronMocap.RabbitMq.Tests.Infrastructure;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.RabbitMq;
using RabbitMQ.Client;

namespace NeuronMocap.RabbitMq.Tests;

public sealed class LiveTests(SharedBroker shared)
{
    private static readonly byte[][] Packets =
    [
        .. Enumerable.Range(0, 100).SelectMany(static frame => new[]
        {
            TestPackets.Motion(frame, avatar: 0, name: "Dr. Who"),
            TestPackets.Motion(frame, avatar: 1, count: 180, name: "#*"),
            TestPackets.Calculation(frame, avatar: 2),
            TestPackets.Studio(frame, avatar: 3),
        }),
    ];

    [Fact]
    public async Task Every_packet_arrives_at_every_source_bit_for_bit()
    {
        Broker broker = await shared.GetAsync();
        await using Audience one = await Audience.StartAsync(broker, "bits");
        await using Audience other = await Audience.StartAsync(broker, "bits");
        await using Stage stage = await Stage.StartAsync(broker, "bits");

        stage.Write(Packets);

        foreach (Audience audience in new[] { one, other })
        {
            await audience.UntilAsync(Packets.Length);
            Assert.Equal(Packets, audience.Packets);
            Assert.Equal(
                new RabbitMqSourceStatistics { Packets = Packets.Length, Bytes = Packets.Sum(static packet => packet.Length), Connections = 1 },
                audience.Source.GetStatistics());
        }
    }

    [Fact]
    public async Task A_publisher_sends_everything_before_it_completes()
    {
        Broker broker = await shared.GetAsync();
        await using Audience audience = await Audience.StartAsync(broker, "end");
        await using Stage stage = await Stage.StartAsync(broker, "end");

        stage.Write(Packets);
        await stage.EndAsync();
        await audience.UntilAsync(Packets.Length);

        RabbitMqPublisherStatistics statistics = stage.Publisher.GetStatistics();
        Assert.Equal((Packets.Length, Packets.Length, 0L, 0), (statistics.Frames, statistics.Published, statistics.Dropped, statistics.Waiting));
        Assert.False(stage.Publisher.Status.IsConnected);
    }

    [Theory]
    [InlineData("Dr. Who", null, 100)]
    [InlineData("#*", null, 100)]
    [InlineData(null, PacketKind.Motion, 200)]
    [InlineData(null, PacketKind.StudioCalculation, 100)]
    [InlineData("#*", PacketKind.Motion, 100)]
    public async Task A_source_gets_only_the_avatar_and_the_kind_that_it_asks_for(string? avatar, PacketKind? kind, int count)
    {
        Broker broker = await shared.GetAsync();
        string name = $"filter {avatar} {kind}";
        RabbitMqSourceOptions options = Audience.Options(broker, name);
        (options.Avatar, options.Kind) = (avatar, kind);
        await using Audience all = await Audience.StartAsync(broker, name);
        await using Audience some = await Audience.StartAsync(options);
        await using Stage stage = await Stage.StartAsync(broker, name);

        // The last frame is one that the source asks for.
        stage.Write(Packets.Where(packet => IsWanted(packet, avatar, kind) || packet != Packets[^1]));
        await some.UntilAsync(count);

        Assert.Equal(Packets.Where(packet => IsWanted(packet, avatar, kind)), some.Packets);
        Assert.Equal(0, some.Source.GetStatistics().Lost);
    }

    [Fact]
    public async Task Another_stage_is_not_received()
    {
        Broker broker = await shared.GetAsync();
        await using Audience audience = await Audience.StartAsync(broker, "stage one");
        await using Stage other = await Stage.StartAsync(broker, "stage two");
        await using Stage stage = await Stage.StartAsync(broker, "stage one");

        other.Write(Packets);
        await other.EndAsync();
        stage.Write(Packets[0]);
        await audience.UntilAsync(1);

        Assert.Equal([Packets[0]], audience.Packets);
    }

    [Fact]
    public async Task Lines_of_text_become_binary_packets_with_their_number_as_frame_index()
    {
        Broker broker = await shared.GetAsync();
        await using Audience audience = await Audience.StartAsync(broker, "text");
        await using Stage stage = await Stage.StartAsync(broker, "text");

        stage.Write(TestPackets.Line(1), TestPackets.Line(2));
        await audience.UntilAsync(2);

        Assert.Equal([1, 2], audience.FrameIndices);
        Assert.Equal(TestPackets.Motion(2)[64..], audience.Packets[1][64..]);
    }

    [Fact]
    public async Task Messages_carry_the_names_and_the_time_of_the_capture()
    {
        Broker broker = await shared.GetAsync();
        await using IConnection connection = await ConnectAsync(broker);
        await using IChannel channel = await connection.CreateChannelAsync(cancellationToken: TestContext.Current.CancellationToken);
        await using Stage stage = await Stage.StartAsync(broker, "a.b");
        QueueDeclareOk queue = await channel.QueueDeclareAsync(cancellationToken: TestContext.Current.CancellationToken);
        await channel.QueueBindAsync(queue.QueueName, RabbitMqOptions.DefaultExchange, "a%2Eb.#", cancellationToken: TestContext.Current.CancellationToken);

        long before = DateTimeOffset.UtcNow.ToUnixTimeMilliseconds();
        stage.Write(Packets[0], Packets[4]);
        await stage.EndAsync();
        long after = DateTimeOffset.UtcNow.ToUnixTimeMilliseconds();

        await GetAsync(channel, queue.QueueName);
        BasicGetResult message = await GetAsync(channel, queue.QueueName);
        IDictionary<string, object?> headers = message.BasicProperties.Headers!;
        Assert.Equal("a%2Eb.Dr%2E Who.motion", message.RoutingKey);
        Assert.Equal(Packets[4], message.Body.ToArray());
        Assert.Equal("a.b", Encoding.UTF8.GetString((byte[])headers["stage"]!));
        Assert.Equal("Dr. Who", Encoding.UTF8.GetString((byte[])headers["avatar"]!));
        Assert.Equal(2L, headers["number"]);

        // A clock that is set back a little between two looks does not matter.
        Assert.InRange((long)headers["captured"]! / 1000, before - 1000, after + 1000);
    }

    [Fact]
    public async Task Messages_that_are_no_packets_are_counted_and_left_out()
    {
        Broker broker = await shared.GetAsync();
        await using Audience audience = await Audience.StartAsync(broker, "garbage");
        await using IConnection connection = await ConnectAsync(broker);
        await using IChannel channel = await connection.CreateChannelAsync(cancellationToken: TestContext.Current.CancellationToken);
        byte[][] garbage =
        [
            [],
            [0xFF],
            new byte[2000],
            Packets[0][..^1],
            [.. Packets[0], .. Packets[1]],
            "hello"u8.ToArray(),
            TestPackets.Motion(0, count: 0),
        ];

        foreach (byte[] body in (byte[][])[.. garbage, Packets[0]])
            await channel.BasicPublishAsync(RabbitMqOptions.DefaultExchange, "garbage.x.motion", body, TestContext.Current.CancellationToken);

        await audience.UntilAsync(1);
        Assert.Equal([Packets[0]], audience.Packets);
        Assert.Equal(garbage.Length, audience.Source.GetStatistics().Invalid);
    }

    // The broker keeps a bounded number of frames for a source, and drops the oldest ones.
    [Fact]
    public async Task A_source_that_is_too_slow_loses_frames_and_counts_each()
    {
        const int Count = 6000;
        Broker broker = await shared.GetAsync();
        RabbitMqSourceOptions options = Audience.Options(broker, "slow");
        options.QueueCapacity = 100;
        await using Audience slow = await Audience.StartAsync(options);
        await using Audience other = await Audience.StartAsync(broker, "slow");
        await using Stage stage = await Stage.StartAsync(broker, "slow");

        slow.Hold();
        foreach (int[] part in Enumerable.Range(0, Count).Chunk(500))
        {
            stage.Write(part.Select(static frame => TestPackets.Motion(frame)));
            await stage.TakenAsync();
        }

        await other.UntilAsync(Count);
        slow.Resume();
        await Limits.UntilAsync(() => slow.LastFrameIndex == Count - 1);

        RabbitMqSourceStatistics statistics = slow.Source.GetStatistics();
        Assert.InRange(statistics.Lost, 1, Count - 100);
        Assert.Equal(Count, statistics.Packets + statistics.Lost);
        Assert.Equal(statistics.Packets, slow.Packets.Length);
        Assert.Equal(0, other.Source.GetStatistics().Lost);
    }

    [Fact]
    public async Task A_second_reader_of_a_source_is_refused()
    {
        Broker broker = await shared.GetAsync();
        await using Audience audience = await Audience.StartAsync(broker, "second");

        await Assert.ThrowsAsync<InvalidOperationException>(async () => await audience.Source.OpenAsync(TestContext.Current.CancellationToken));
    }

    private static Task<IConnection> ConnectAsync(Broker broker) =>
        new ConnectionFactory { HostName = "127.0.0.1", Port = broker.Port }.CreateConnectionAsync(TestContext.Current.CancellationToken);

    // At its end, a publisher without confirmations waits some seconds for the broker. A busy broker can take longer.
    private static async Task<BasicGetResult> GetAsync(IChannel channel, string queue)
    {
        using var limit = CancellationTokenSource.CreateLinkedTokenSource(TestContext.Current.CancellationToken);
        limit.CancelAfter(Limits.Unexpected);
        BasicGetResult? message;
        while ((message = await channel.BasicGetAsync(queue, autoAck: true, limit.Token)) is null)
            await Task.Delay(10, limit.Token);

        return message;
    }

    private static bool IsWanted(byte[] packet, string? avatar, PacketKind? kind)
    {
        (string name, PacketKind own) = packet[0] == 0xCF ? ("Char00", PacketKind.StudioCalculation)
            : MotionHeader.TryRead(packet, out MotionHeader header) ? (header.AvatarName.ToString(), PacketKind.Motion)
            : ("Char00", PacketKind.Calculation);
        return (avatar is null || avatar == name) && (kind is null || kind == own);
    }
}
