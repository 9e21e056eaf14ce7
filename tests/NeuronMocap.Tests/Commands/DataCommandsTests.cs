using System.Net.Sockets;
using NeuronMocap.Commands;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Commands;

public sealed class DataCommandsTests : IDisposable
{
    private readonly TestServer _server = new();

    public void Dispose() => _server.Dispose();

    [Fact]
    public async Task Requests_have_the_vendors_64_bytes()
    {
        await using NeuronReader reader = await ConnectAsync();
        using TestConnection connection = await _server.AcceptAsync();

        Assert.True(reader.DataCommands.TryRequest(DataCommandId.AvatarCount));
        Assert.True(reader.DataCommands.TryRequest(DataCommandId.BoneSize, avatarIndex: 2));
        Assert.True(reader.DataCommands.TryRegister(DataCommandId.CombinationMode));
        Assert.True(reader.DataCommands.TryUnregister(DataCommandId.CombinationMode));

        Assert.Equal(Request(id: 5, parameter: 0), await ReadRequestAsync(connection));
        Assert.Equal(Request(id: 0, parameter: 2), await ReadRequestAsync(connection));
        Assert.Equal(Request(id: 7, parameter: 6), await ReadRequestAsync(connection));
        Assert.Equal(Request(id: 8, parameter: 6), await ReadRequestAsync(connection));
    }

    [Fact]
    public async Task Replies_and_pushes_between_frames_reach_their_requests()
    {
        await using NeuronReader reader = await ConnectAsync();
        using TestConnection connection = await _server.AcceptAsync();
        List<DataCommandId> received = [];
        reader.DataCommands.Received += _ => throw new InvalidOperationException("A handler of the user's.");
        reader.DataCommands.Received += reply => received.Add(reply.Id);

        Task<IReadOnlyList<BoneSize>> sizes = reader.DataCommands.GetBoneSizesAsync();
        Task<int> count = reader.DataCommands.GetAvatarCountAsync();
        Task<string> text = reader.DataCommands.GetBvhTextAsync();
        Task<CombinationMode> mode = reader.DataCommands.GetCombinationModeAsync(avatarIndex: 1);
        await connection.SendPiecesAsync(
            TestPackets.Join(
                DataReplies.CombinationMode(avatar: 0, mode: 1),
                TestPackets.Motion(1),
                DataReplies.BoneSizes(("Hips", 0.5f)),
                DataReplies.AvatarCount(2),
                TestPackets.Motion(2),
                DataReplies.CombinationMode(avatar: 1, mode: 2),
                DataReplies.BvhText("HIERARCHY")),
            size: 37);

        Assert.Equal([new BoneSize("Hips", 0.5f)], await sizes.Soon());
        Assert.Equal(2, await count.Soon());
        Assert.Equal("HIERARCHY", await text.Soon());
        Assert.Equal(CombinationMode.FullBody, await mode.Soon());
        await reader.UntilAsync(static statistics => statistics.CommandPackets == 5);
        Assert.Equal((2L, 0L, 5L), (reader.GetStatistics().MotionFrames, reader.GetStatistics().BytesSkipped, reader.GetStatistics().CallbackFailures));
        Assert.Equal(
            [DataCommandId.CombinationMode, DataCommandId.BoneSize, DataCommandId.AvatarCount, DataCommandId.CombinationMode, DataCommandId.BvhText],
            received);
    }

    [Fact]
    public async Task Concurrent_requests_get_their_own_avatars_answers()
    {
        const int Avatars = 50;
        await using NeuronReader reader = await ConnectAsync();
        using TestConnection connection = await _server.AcceptAsync();

        Task<int>[] frequencies = [.. Enumerable.Range(0, Avatars).Select(avatar => Task.Run(() => reader.DataCommands.GetFrameRateAsync(avatar)))];
        for (int i = 0; i < Avatars; i++)
            await ReadRequestAsync(connection);
        await connection.SendAsync(TestPackets.Join(Enumerable.Range(0, Avatars).Reverse().Select(avatar => DataReplies.Frequency(avatar, 1000 + avatar))));

        Assert.Equal(Enumerable.Range(1000, Avatars), await Task.WhenAll(frequencies).Soon());
    }

    [Fact]
    public async Task A_timeout_is_reported_and_the_next_request_is_answered()
    {
        await using NeuronReader reader = await ConnectAsync();
        using TestConnection connection = await _server.AcceptAsync();
        reader.DataCommands.Timeout = TimeSpan.FromMilliseconds(50);

        NeuronCommandException exception = await Assert.ThrowsAsync<NeuronCommandException>(() => reader.DataCommands.GetAvatarCountAsync().Soon());
        Assert.Equal(CommandFailure.TimedOut, exception.Reason);
        Assert.Contains("8013", exception.Message, StringComparison.Ordinal);

        reader.DataCommands.Timeout = TimeSpan.FromMinutes(1);
        Task<int> count = reader.DataCommands.GetAvatarCountAsync();
        await connection.SendAsync(DataReplies.AvatarCount(4));
        Assert.Equal(4, await count.Soon());
    }

    [Fact]
    public async Task A_wait_can_be_cancelled()
    {
        await using NeuronReader reader = await ConnectAsync();
        using TestConnection connection = await _server.AcceptAsync();
        using var cancellation = new CancellationTokenSource();

        Task<string> text = reader.DataCommands.GetBvhTextAsync(cancellationToken: cancellation.Token);
        await ReadRequestAsync(connection);
        cancellation.Cancel();

        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => text.Soon());
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => reader.DataCommands.GetBvhTextAsync(cancellationToken: cancellation.Token).Soon());
    }

    [Fact]
    public async Task Requests_need_a_TCP_connection()
    {
        using var idle = new NeuronReader(_server.Options());
        Assert.False(idle.DataCommands.TryRequest(DataCommandId.AvatarCount));
        Assert.False(idle.DataCommands.TryRegister(DataCommandId.AvatarCount));
        Assert.False(idle.DataCommands.TryUnregister(DataCommandId.AvatarCount));

        await using var udp = new NeuronReader(new NeuronReaderOptions { Transport = TransportKind.Udp, Port = 0 });
        await udp.StartAsync(TestContext.Current.CancellationToken).Soon();
        NeuronCommandException exception = await Assert.ThrowsAsync<NeuronCommandException>(() => udp.DataCommands.GetAvatarCountAsync().Soon());
        Assert.Equal(CommandFailure.NotConnected, exception.Reason);
    }

    [Fact]
    public async Task Registrations_are_renewed_on_every_connection()
    {
        await using NeuronReader reader = await ConnectAsync(reconnect: true);
        using (TestConnection first = await _server.AcceptAsync())
        {
            Assert.True(reader.DataCommands.TryRegister(DataCommandId.CombinationMode));
            Assert.True(reader.DataCommands.TryRegister(DataCommandId.BoneSize));
            Assert.True(reader.DataCommands.TryRegister(DataCommandId.AvatarCount));
            Assert.True(reader.DataCommands.TryUnregister(DataCommandId.BoneSize));
            for (int i = 0; i < 4; i++)
                await ReadRequestAsync(first);
        }

        using TestConnection second = await _server.AcceptAsync();
        Assert.Equal(Request(id: 7, parameter: 5), await ReadRequestAsync(second));
        Assert.Equal(Request(id: 7, parameter: 6), await ReadRequestAsync(second));
    }

    [Fact]
    public async Task A_server_that_reads_no_commands_blocks_senders_but_no_frames()
    {
        await using NeuronReader reader = await ConnectAsync();
        using TestConnection connection = await _server.AcceptAsync();

        Task<bool> sending = Task.Run(() =>
        {
            while (reader.DataCommands.TryRequest(DataCommandId.AvatarCount))
            {
            }

            return true;
        });
        for (int frame = 0; !sending.IsCompleted; frame++)
        {
            await connection.SendAsync(TestPackets.Motion(frame));
            await reader.WaitForFramesAsync(frame + 1);
        }

        Assert.True(await sending);
        Assert.True(reader.Status.IsConnected);
    }

    [Fact]
    public async Task Requests_can_be_sent_from_the_handler_of_a_reply()
    {
        await using NeuronReader reader = await ConnectAsync();
        using TestConnection connection = await _server.AcceptAsync();
        reader.DataCommands.Received += reply => reader.DataCommands.TryRequest(DataCommandId.DataFrequency, reply.AvatarCount ?? 0);

        await connection.SendAsync(DataReplies.AvatarCount(7));
        Assert.Equal(Request(id: 3, parameter: 7), await ReadRequestAsync(connection));
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task Pending_requests_fail_when_the_connection_ends(bool reconnect)
    {
        await using NeuronReader reader = await ConnectAsync(reconnect);
        reader.DataCommands.Timeout = TimeSpan.FromMinutes(10);
        TestConnection connection = await _server.AcceptAsync();
        Task[] fetches = [reader.DataCommands.GetAvatarCountAsync(), reader.DataCommands.GetBoneSizesAsync(), reader.DataCommands.GetFrameRateAsync()];
        for (int i = 0; i < fetches.Length; i++)
            await ReadRequestAsync(connection);

        connection.Dispose();
        foreach (Task fetch in fetches)
            Assert.Equal(CommandFailure.Closed, (await Assert.ThrowsAsync<NeuronCommandException>(() => fetch.Soon())).Reason);

        if (!reconnect)
            return;

        // No request of the old connection is pending.
        using TestConnection second = await _server.AcceptAsync();
        await Limits.UntilAsync(() => reader.Status.IsConnected);
        Task<IReadOnlyList<BoneSize>> sizes = reader.DataCommands.GetBoneSizesAsync(avatarIndex: 1);
        Assert.Equal(Request(id: 0, parameter: 1), await ReadRequestAsync(second));
        await second.SendAsync(DataReplies.BoneSizes(("Hips", 0.5f)));
        Assert.Equal([new BoneSize("Hips", 0.5f)], await sizes.Soon());
    }

    [Fact]
    public async Task Disposing_the_reader_ends_a_pending_request()
    {
        NeuronReader reader = await ConnectAsync();
        reader.DataCommands.Timeout = TimeSpan.FromMinutes(10);
        using TestConnection connection = await _server.AcceptAsync();
        Task<string> text = reader.DataCommands.GetBvhTextAsync();
        await ReadRequestAsync(connection);
        await reader.DisposeAsync();
        Assert.Equal(CommandFailure.Closed, (await Assert.ThrowsAsync<NeuronCommandException>(() => text.Soon())).Reason);
    }

    [Fact]
    public async Task Requests_with_ambiguous_replies_are_sent_one_at_a_time()
    {
        await using NeuronReader reader = await ConnectAsync();
        using TestConnection connection = await _server.AcceptAsync();
        Task<IReadOnlyList<BoneSize>>[] sizes = [.. Enumerable.Range(0, 3).Select(avatar => reader.DataCommands.GetBoneSizesAsync(avatar))];
        for (int avatar = 0; avatar < sizes.Length; avatar++)
        {
            Assert.Equal(Request(id: 0, avatar), await ReadRequestAsync(connection));
            Assert.Equal(0, connection.Socket.Available);
            await connection.SendAsync(DataReplies.BoneSizes(("Hips", avatar + 0.5f)));
            Assert.Equal([new BoneSize("Hips", avatar + 0.5f)], await sizes[avatar].Soon());
        }
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task A_late_reply_is_never_used_for_another_avatar(bool isLate)
    {
        await using NeuronReader reader = await ConnectAsync();
        using TestConnection connection = await _server.AcceptAsync();
        reader.DataCommands.Timeout = TimeSpan.FromMilliseconds(20);
        await Assert.ThrowsAsync<NeuronCommandException>(() => reader.DataCommands.GetBoneSizesAsync(avatarIndex: 0).Soon());
        Assert.Equal(Request(id: 0, parameter: 0), await ReadRequestAsync(connection));

        reader.DataCommands.Timeout = TimeSpan.FromMinutes(10);
        Task<IReadOnlyList<BoneSize>> sizes = reader.DataCommands.GetBoneSizesAsync(avatarIndex: 1);
        if (isLate)
            await connection.SendAsync(DataReplies.BoneSizes(("Hips", 0.25f)));

        Assert.Equal(Request(id: 5, parameter: 0), await ReadRequestAsync(connection));
        await connection.SendAsync(DataReplies.AvatarCount(2));
        Assert.Equal(Request(id: 0, parameter: 1), await ReadRequestAsync(connection));
        await connection.SendAsync(DataReplies.BoneSizes(("Hips", 0.75f)));
        Assert.Equal([new BoneSize("Hips", 0.75f)], await sizes.Soon());
    }

    [Fact]
    public async Task A_request_that_was_not_sent_leaves_no_late_reply()
    {
        await using var reader = new NeuronReader(_server.Options());
        await Assert.ThrowsAsync<NeuronCommandException>(() => reader.DataCommands.GetBoneSizesAsync().Soon());
        await reader.StartAsync(TestContext.Current.CancellationToken).Soon();
        using TestConnection connection = await _server.AcceptAsync();
        Task<IReadOnlyList<BoneSize>> sizes = reader.DataCommands.GetBoneSizesAsync(avatarIndex: 1);
        Assert.Equal(Request(id: 0, parameter: 1), await ReadRequestAsync(connection));
        await connection.SendAsync(DataReplies.BoneSizes(("Hips", 0.75f)));
        Assert.Equal([new BoneSize("Hips", 0.75f)], await sizes.Soon());
    }

    private async Task<NeuronReader> ConnectAsync(bool reconnect = false)
    {
        var reader = new NeuronReader(_server.Options(reconnect));
        reader.DataCommands.Timeout = Limits.Unexpected;
        await reader.StartAsync(TestContext.Current.CancellationToken).Soon();
        return reader;
    }

    private static string Request(int id, int parameter) => Convert.ToHexString(DataReplies.Make(id, dataCount: 0, parameter, value: 0, []));

    private static async Task<string> ReadRequestAsync(TestConnection connection)
    {
        byte[] request = new byte[64];
        for (int length = 0; length < request.Length;)
        {
            int count = await connection.Socket.ReceiveAsync(request.AsMemory(length), SocketFlags.None).AsTask().Soon();
            Assert.NotEqual(0, count);
            length += count;
        }

        return Convert.ToHexString(request);
    }
}
