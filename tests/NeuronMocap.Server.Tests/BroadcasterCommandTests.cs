using System.Net.Sockets;
using System.Text;
using NeuronMocap.Bvh;
using NeuronMocap.Commands;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Server;
using static NeuronMocap.Server.Tests.Broadcasts;

namespace NeuronMocap.Server.Tests;

// Commands of the old generation, which share the connection with the frames.
public sealed class BroadcasterCommandTests
{
    public static TheoryData<double, int?> Ways { get; } = new()
    {
        { 500, null },
        { 500, 7 },
        { BroadcasterOptions.MaxFrameRate, null },
        { BroadcasterOptions.MaxFrameRate, 1481 },
        { BroadcasterOptions.MaxFrameRate, 200_000 },
    };

    [Theory]
    [MemberData(nameof(Ways))]
    public async Task Every_value_is_answered_and_no_frame_is_missing(double rate, int? fragment)
    {
        BroadcasterOptions options = Options(rate, avatars: 2);
        options.Fragment = fragment;
        options.RotationOrder = RotationOrder.ZXY;
        await using Broadcaster broadcaster = Started(options);
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        await SendAsync(client, [.. Requests.Create(5, 99), .. Requests.Create(3, 1), .. Requests.Create(6, 1), .. Requests.Create(0, 1), .. Requests.Create(4, 0)]);
        (List<DataCommandReply> replies, List<byte[]> frames) = await ReadRepliesAsync(client, 5);
        int frequency = double.IsInfinity(rate) ? 60 : 500;

        Assert.Equal(DataReplies.AvatarCount(2), replies[0].Packet.ToArray());
        Assert.Equal(DataReplies.Frequency(1, frequency), replies[1].Packet.ToArray());
        Assert.Equal(DataReplies.CombinationMode(1, 2), replies[2].Packet.ToArray());
        AssertBones(replies[3]);
        AssertText(replies[4]);
        Expect.Frames(frames[..(frames.Count / 2 * 2)], options, frames.Count / 2);

        // A reply counts after it is sent, so the client may have it earlier.
        await AssertSentAsync(broadcaster, replies: 5);
        Assert.Equal((0L, 0L), (broadcaster.GetStatistics().RequestsIgnored, broadcaster.GetStatistics().RequestsDropped));
    }

    [Fact]
    public async Task Requests_in_single_bytes_and_amid_garbage_are_answered()
    {
        await using Broadcaster broadcaster = Started(Options(500));
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        client.Socket.NoDelay = true;
        foreach (byte octet in (byte[])[0xFF, 0xAA, 7, .. Requests.Create(5, 0), 0xFF, .. Requests.Create(6, 0)])
            await SendAsync(client, [octet]);

        (List<DataCommandReply> replies, _) = await ReadRepliesAsync(client, 2);
        Assert.Equal([DataCommandId.AvatarCount, DataCommandId.CombinationMode], replies.Select(reply => reply.Id));
    }

    // The next frame is due in 100 seconds.
    [Fact]
    public async Task An_answer_does_not_wait_for_the_next_frame()
    {
        await using Broadcaster broadcaster = Started(Options(0.01));
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        Assert.NotNull(await client.ReadAsync());
        await SendAsync(client, Requests.Create(5, 0));
        Assert.Single((await ReadRepliesAsync(client, 1)).Replies);
        await SendAsync(client, Requests.Create(3, 0));

        // A rate below one half is reported as 0.
        Assert.Equal(0, Assert.Single((await ReadRepliesAsync(client, 1)).Replies).FrameRate);
    }

    [Fact]
    public async Task Unknown_commands_are_ignored_and_counted()
    {
        await using Broadcaster broadcaster = Started(Options(500));
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        byte[][] strange =
        [
            Requests.Create(1, 0), Requests.Create(2, 0), Requests.Create(9, 0), Requests.Create(-1, 0), Requests.Create(1001, 0),
            Requests.Create(0, 1), Requests.Create(4, -1), Requests.Create(6, int.MaxValue), Requests.Create(7, 1), Requests.Create(8, 77),
        ];
        await SendAsync(client, [.. strange.SelectMany(bytes => bytes), .. Requests.Create(5, 0)]);

        Assert.Equal(DataCommandId.AvatarCount, Assert.Single((await ReadRepliesAsync(client, 1)).Replies).Id);
        Assert.Equal(strange.Length, broadcaster.GetStatistics().RequestsIgnored);
        await AssertSentAsync(broadcaster, replies: 1);
        Assert.Equal(strange.Length, Assert.Single(broadcaster.GetClients()).RequestsIgnored);
    }

    [Fact]
    public async Task A_registered_value_is_sent_at_once_and_on_every_change()
    {
        await using Broadcaster broadcaster = Started(Options(0.01, avatars: 2));
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        await SendAsync(client, Requests.Create(7, 6));
        Assert.Equal([(0, 2), (1, 2)], await ReadModesAsync(client, 2));

        broadcaster.SetCombinationMode(1, CombinationMode.ArmOnly);
        Assert.Equal([(1, 0)], await ReadModesAsync(client, 1));
        broadcaster.SetCombinationMode(1, CombinationMode.ArmOnly);
        broadcaster.SetCombinationMode(0, CombinationMode.UpperBody);
        Assert.Equal([(0, 1)], await ReadModesAsync(client, 1));
        Assert.Equal(CombinationMode.UpperBody, broadcaster.GetCombinationMode(0));

        // A following request shows that nothing else is in transit.
        await SendAsync(client, [.. Requests.Create(8, 6), .. Requests.Create(5, 0)]);
        Assert.Equal(DataCommandId.AvatarCount, Assert.Single((await ReadRepliesAsync(client, 1)).Replies).Id);
        broadcaster.SetCombinationMode(0, CombinationMode.FullBody);
        await SendAsync(client, Requests.Create(6, 0));
        Assert.Equal([(0, 2)], await ReadModesAsync(client, 1));
        await AssertSentAsync(broadcaster, replies: 6);
        Assert.Throws<ArgumentOutOfRangeException>(() => broadcaster.SetCombinationMode(2, CombinationMode.FullBody));
        Assert.Throws<ArgumentOutOfRangeException>(() => broadcaster.GetCombinationMode(-1));
    }

    [Fact]
    public async Task Each_of_many_clients_gets_only_its_own_answers()
    {
        const int Clients = 12;
        BroadcasterOptions options = Options(200, avatars: Clients);
        await using Broadcaster broadcaster = Started(options);
        using TestClient witness = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        await Task.WhenAll(Enumerable.Range(0, Clients).Select(async avatar =>
        {
            using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
            for (int i = 0; i < 5; i++)
            {
                await SendAsync(client, [.. Requests.Create(6, avatar), .. Requests.Create(3, avatar)]);
                (List<DataCommandReply> replies, _) = await ReadRepliesAsync(client, 2);
                Assert.Equal([DataCommandId.CombinationMode, DataCommandId.DataFrequency], replies.Select(reply => reply.Id));
                Assert.All(replies, reply => Assert.Equal(avatar, reply.AvatarIndex));
            }
        }));

        for (int i = 0; i < 100; i++)
            Assert.True(MotionHeader.TryRead((await witness.ReadAsync())!, out _));
        await AssertSentAsync(broadcaster, replies: Clients * 5 * 2);
    }

    [Fact]
    public async Task A_flood_of_requests_is_bounded_and_does_not_affect_other_clients()
    {
        const int Flood = 5000;
        BroadcasterOptions options = Options(300);
        options.QueueCapacity = 20_000;
        await using Broadcaster broadcaster = Started(options);
        using TestClient witness = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        using TestClient flooder = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        Assert.NotNull(await flooder.ReadAsync());

        // The client reads nothing, so its long texts block. A thousand requests wait, and further ones are dropped.
        Task sending = SendAsync(flooder, [.. Enumerable.Repeat(Requests.Create(4, 0), Flood).SelectMany(bytes => bytes)]);
        List<byte[]> packets = [];
        while (broadcaster.GetStatistics().RequestsDropped < Flood / 2)
            packets.Add((await witness.ReadAsync())!);

        await sending.Soon();
        Expect.Frames(packets, options, packets.Count);

        // Requests that were not dropped are answered when the client reads.
        int replies = 0;
        while (replies < Flood - broadcaster.GetStatistics().RequestsDropped || broadcaster.GetStatistics().RepliesSent + broadcaster.GetStatistics().RequestsDropped < Flood)
            replies += DataCommandHeader.TryRead((await flooder.ReadAsync())!, out _) ? 1 : 0;

        Assert.Equal(Flood, replies + broadcaster.GetStatistics().RequestsDropped);
        Assert.Equal(broadcaster.GetStatistics().RepliesSent, replies);
    }

    [Fact]
    public async Task A_server_of_the_newer_kind_does_not_answer()
    {
        BroadcasterOptions options = Options(500);
        options.AnswerDataCommands = false;
        await using Broadcaster broadcaster = Started(options);
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        await SendAsync(client, [.. Requests.Create(5, 0), .. Requests.Create(7, 6)]);
        for (int i = 0; i < 100; i++)
        {
            broadcaster.SetCombinationMode(0, (CombinationMode)(i % 2));
            Assert.True(MotionHeader.TryRead((await client.ReadAsync())!, out _));
        }

        Assert.Equal((0L, 0L), (broadcaster.GetStatistics().RepliesSent, broadcaster.GetStatistics().RequestsIgnored));
    }

    [Theory]
    [InlineData(4)]
    [InlineData(192)]
    [InlineData(-1)]
    public async Task The_length_field_is_ignored(int length)
    {
        BroadcasterOptions options = Options(500);
        options.DataCommandLength = length;
        await using Broadcaster broadcaster = Started(options);
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        await SendAsync(client, Requests.Create(0, 0));
        DataCommandReply reply = Assert.Single((await ReadRepliesAsync(client, 1)).Replies);
        Assert.Equal(length, BitConverter.ToInt32(reply.Packet.Span[6..10]));
        AssertBones(reply);
    }

    [Fact]
    public async Task Answers_are_sent_between_lines_of_text()
    {
        BroadcasterOptions options = Options(300);
        options.Format = BroadcastFormat.Text;
        options.MaxFrames = 60;
        var time = new ManualTime();
        await using var broadcaster = new Broadcaster(options, time);
        broadcaster.Start();
        using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        await socket.ConnectAsync(broadcaster.LocalEndPoint!, TestContext.Current.CancellationToken).AsTask().Soon();
        Task<string> reading = TextClient.ReadToEndAsync(socket);
        for (int frame = 1; frame < 60; frame++)
        {
            await time.PassAsync();
            if (frame == 30)
            {
                await socket.SendAsync(Requests.Create(4, 0), TestContext.Current.CancellationToken).Soon();
                await Limits.UntilAsync(() => broadcaster.GetStatistics().RepliesSent == 1);
            }
        }

        string text = await reading;

        // All of the text is ASCII, but the two tokens of the reply are not.
        int begin = text.IndexOf('\uFFFD', StringComparison.Ordinal);
        int end = text.LastIndexOf('\uFFFD');
        Assert.True(begin == 0 || text[begin - 1] == '\n');
        int hierarchy = text.IndexOf("HIERARCHY", end, StringComparison.Ordinal);
        Assert.Equal(end + 1, hierarchy);
        Assert.Equal(60, text.Split(" ||\r\n").Length - 1);
        await AssertSentAsync(broadcaster, replies: 1);
    }

    [Fact]
    public async Task NeuronReader_gets_every_answer_and_frame()
    {
        await using Broadcaster broadcaster = Started(Options(300, avatars: 3));
        await using var reader = new NeuronReader("127.0.0.1", broadcaster.LocalEndPoint!.Port);
        var modes = new System.Collections.Concurrent.ConcurrentQueue<(int? Avatar, CombinationMode? Mode)>();
        reader.DataCommands.Received += reply => modes.Enqueue((reply.AvatarIndex, reply.CombinationMode));
        reader.DataCommands.Timeout = Limits.Unexpected;
        reader.Start();
        await Limits.UntilAsync(() => reader.Status.IsConnected);
        CancellationToken cancellationToken = TestContext.Current.CancellationToken;

        Assert.Equal(3, await reader.DataCommands.GetAvatarCountAsync(cancellationToken));
        Assert.Equal(300, await reader.DataCommands.GetFrameRateAsync(2, cancellationToken));
        Assert.Equal(59, (await reader.DataCommands.GetBoneSizesAsync(1, cancellationToken)).Count);
        Assert.StartsWith("HIERARCHY", await reader.DataCommands.GetBvhTextAsync(0, cancellationToken), StringComparison.Ordinal);
        Assert.True(reader.DataCommands.TryRegister(DataCommandId.CombinationMode));
        broadcaster.SetCombinationMode(2, CombinationMode.UpperBody);
        await Limits.UntilAsync(() => modes.Contains((2, CombinationMode.UpperBody)));
        Assert.Equal(0, reader.GetStatistics().BytesSkipped);
    }

    [Fact]
    public async Task A_source_without_a_body_ends_the_broadcast_with_a_reason()
    {
        BroadcasterOptions options = Options(300);
        options.Sources = [new BodilessSource()];
        await using Broadcaster broadcaster = Started(options);
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        await SendAsync(client, Requests.Create(0, 0));
        await Assert.ThrowsAsync<InvalidDataException>(() => broadcaster.Completion.Soon());
    }

    // A reply counts after it is sent, so it may be read earlier.
    private static async Task AssertSentAsync(Broadcaster broadcaster, long replies)
    {
        await Limits.UntilAsync(() => broadcaster.GetStatistics().RepliesSent >= replies);
        Assert.Equal(replies, broadcaster.GetStatistics().RepliesSent);
    }

    private static BroadcasterOptions Options(double rate, int avatars = 1)
    {
        BroadcasterOptions options = Expect.Options(avatars);
        options.Sources = [.. Enumerable.Range(0, avatars).Select(avatar => new SyntheticSource(60, avatar))];
        options.FrameRate = rate;
        options.WaitForClient = true;
        options.QueueCapacity = 10_000;
        return options;
    }

    private static Task<int> SendAsync(TestClient client, byte[] bytes) =>
        client.Socket.SendAsync(bytes, TestContext.Current.CancellationToken).AsTask();

    // Fails unless the stream consists of whole packets.
    private static async Task<(List<DataCommandReply> Replies, List<byte[]> Frames)> ReadRepliesAsync(TestClient client, int count)
    {
        var replies = new List<DataCommandReply>();
        var frames = new List<byte[]>();
        while (replies.Count < count)
        {
            byte[] packet = Assert.IsType<byte[]>(await client.ReadAsync());
            if (DataCommandHeader.TryRead(packet, out _))
                replies.Add(new DataCommandReply(packet));
            else
                frames.Add(packet);
        }

        return (replies, frames);
    }

    private static async Task<List<(int? Avatar, int? Mode)>> ReadModesAsync(TestClient client, int count) =>
        [.. (await ReadRepliesAsync(client, count)).Replies.Select(reply => (reply.AvatarIndex, (int?)reply.CombinationMode))];

    private static void AssertBones(DataCommandReply reply)
    {
        IReadOnlyList<BoneSize> sizes = Assert.IsAssignableFrom<IReadOnlyList<BoneSize>>(reply.BoneSizes);
        Assert.Equal(BoneHierarchy.Bones.ToArray().Select(bone => BoneHierarchy.GetName(bone)), sizes.Select(size => size.Name));
        Assert.Equal(DefaultOffsets.Get(Bone.RightLeg).Length() / 100, sizes[(int)Bone.RightUpLeg].Length, 1e-6f);
        Assert.Equal(DefaultOffsets.Get(Bone.Spine).Length() / 100, sizes[(int)Bone.Hips].Length, 1e-6f);
        Assert.Equal(DefaultOffsets.Get(Bone.LeftInHandMiddle).Length() / 100, sizes[(int)Bone.LeftHand].Length, 1e-6f);
        Assert.True(DefaultOffsets.TryGetEndSite(Bone.Head, out System.Numerics.Vector3 end));
        Assert.Equal(end.Length() / 100, sizes[(int)Bone.Head].Length, 1e-6f);
    }

    private static void AssertText(DataCommandReply reply)
    {
        string text = Assert.IsType<string>(reply.BvhText);
        Assert.Equal(text.Length, (int)reply.Header.DataCount);
        Assert.EndsWith("}\r\n", text, StringComparison.Ordinal);
        Assert.Equal(59 * 6, BvhDocument.Parse(Encoding.ASCII.GetBytes(text + "MOTION\r\nFrames: 0\r\nFrame Time: 0.01\r\n")).ChannelCount);
        Assert.Contains("Zrotation Xrotation Yrotation", text, StringComparison.Ordinal);
    }

    private sealed class BodilessSource : MotionSource
    {
        public override double FrameRate => 60;

        public override long? FrameCount => null;

        public override bool HasDisplacement => false;

        public override void GetPose(long frame, Span<BoneTransform> pose) => throw new InvalidDataException("There is no body.");

        public override FootContacts GetFootContacts(long frame) => new(false, false);

        public override void WriteValues(long frame, ChannelLayout layout, RotationOrder order, Span<float> values) => values.Clear();
    }
}
