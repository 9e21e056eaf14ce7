using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Commands;
using NeuronMocap.Protocol;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Bvh;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Server.Sources;

namespace NeuronMocap.Tests.Server;

public sealed class CommandServerTests
{
    [Theory]
    [InlineData(RotationOrder.XZY, false, false)]
    [InlineData(RotationOrder.YXZ, true, false)]
    [InlineData(RotationOrder.ZYX, true, true)]
    public async Task The_answers_are_those_of_the_broadcaster(RotationOrder order, bool displacement, bool reference)
    {
        using Broadcaster broadcaster = CreateBroadcaster(options =>
        {
            options.RotationOrder = order;
            options.Displacement = displacement;
            options.Reference = reference;
        });
        using CommandServer server = Start(broadcaster);
        using NeuronCommandClient client = CreateClient(server);

        Assert.Equal(order, await client.GetRotationOrderAsync().Soon());
        Assert.Equal(BoneDimensions.Measure(DefaultBody()), await client.GetBoneDimensionsAsync(0).Soon());
        BvhDocument header = await client.GetBvhHeaderAsync(1).Soon();
        Assert.Empty(header.Repairs);
        Assert.Equal(0, header.FrameCount);
        Assert.True(BvhSkeletonMap.TryCreate(header, out BvhSkeletonMap? map, out string? reason), reason);
        Assert.Equal(new SkeletonFormat(order, SkeletonVariant.Neck1), map.Format);
        Assert.Equal(broadcaster.Layout, map.Layout);
    }

    [Fact]
    public async Task A_takes_own_body_is_told()
    {
        // Joint n is at (n, 0.5, -1) and ends at (0, 1, 0).
        BvhDocument take = BvhSamples.Parse(BvhSamples.Neuron(SkeletonVariant.Spine3));
        using Broadcaster broadcaster = CreateBroadcaster(options => options.Sources = [new LoopedSource(new BvhSource(take))]);
        using CommandServer server = Start(broadcaster);
        using NeuronCommandClient client = CreateClient(server);

        BoneDimensions sizes = await client.GetBoneDimensionsAsync(0).Soon();
        Assert.Equal(0.01f, sizes.Head, 1e-6);
        Assert.Equal(0.01f, sizes.HeelHeight, 1e-6);
        Assert.Equal(new Vector3((int)Bone.Head, 0.5f, -1).Length() / 100, sizes.Neck, 1e-6);
        BvhDocument header = await client.GetBvhHeaderAsync(0).Soon();
        Assert.Equal(take.Joints.Select(joint => (joint.Name, joint.Offset, joint.EndSite)), header.Joints.Select(joint => (joint.Name, joint.Offset, joint.EndSite)));
        Assert.Equal(59, header.FrameRate, 1.0);
    }

    [Fact]
    public async Task An_avatar_that_there_is_not_is_told_as_such()
    {
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster);
        using NeuronCommandClient client = CreateClient(server);
        await CommandAnswerTests.FailsAsync(client.ZeroOutAsync(3), CommandFailure.Rejected, "avatar 3");
        await CommandAnswerTests.FailsAsync(client.GetBoneDimensionsAsync(3), CommandFailure.Rejected, "avatar 3");
        await CommandAnswerTests.FailsAsync(client.GetBvhHeaderAsync(int.MaxValue), CommandFailure.Rejected, "avatar 2147483647");
        await client.ZeroOutAsync(2).Soon();
    }

    [Fact]
    public async Task A_zero_out_makes_the_avatar_face_front_and_no_other()
    {
        using Broadcaster broadcaster = CreateBroadcaster(options =>
        {
            options.Sources = [Still(heading: 100), Still(heading: -60)];
            options.RotationOrder = RotationOrder.ZXY;
        });
        using CommandServer server = Start(broadcaster);
        broadcaster.Start();
        using NeuronCommandClient client = CreateClient(server);
        double[] headings = new double[2];
        using var reader = new NeuronReader(new NeuronReaderOptions { Port = broadcaster.LocalEndPoint!.Port, RotationOrder = RotationOrder.ZXY });
        reader.MotionReceived += frame => Volatile.Write(ref headings[frame.AvatarIndex], TurnableSourceTests.Heading(frame[Bone.Hips]));
        reader.Start();
        await Limits.UntilAsync(() => IsNear(ref headings[0], 100) && IsNear(ref headings[1], -60));

        await client.ZeroOutAsync(0).Soon();
        await Limits.UntilAsync(() => IsNear(ref headings[0], 0));
        Assert.True(IsNear(ref headings[1], -60));
        await client.ZeroOutAllAsync().Soon();
        await Limits.UntilAsync(() => IsNear(ref headings[1], 0));
        Assert.True(IsNear(ref headings[0], 0));
    }

    [Fact]
    public async Task A_handler_on_the_receive_thread_may_ask()
    {
        using Broadcaster broadcaster = CreateBroadcaster(options => options.RotationOrder = RotationOrder.XYZ);
        using CommandServer server = Start(broadcaster);
        broadcaster.Start();
        using NeuronCommandClient client = CreateClient(server);
        var answer = new TaskCompletionSource<RotationOrder>(TaskCreationOptions.RunContinuationsAsynchronously);
        using var reader = new NeuronReader("127.0.0.1", broadcaster.LocalEndPoint!.Port);
        reader.MotionReceived += _ => answer.TrySetResult(client.GetRotationOrderAsync().GetAwaiter().GetResult());
        reader.Start();
        Assert.Equal(RotationOrder.XYZ, await answer.Task.Soon());
    }

    [Fact]
    public async Task Command_type_and_reserved_field_of_a_request_have_no_meaning()
    {
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster);
        using Socket socket = Connect(server);
        byte[] request = new byte[16];
        new CommandChannelHeader { CommandType = 0x7A79, CommandId = 1003, Reserved = 0x03EA0000 }.Write(request);
        socket.Send(request);

        Assert.Equal(CommandScript.Packet([1, 0, 0, 0], 1003), await ReadAsync(socket, 20));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1000)]
    [InlineData(1006)]
    [InlineData(65_535)]
    public async Task A_command_that_is_not_known_has_an_empty_answer(int id)
    {
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster);
        using Socket socket = Connect(server);
        socket.Send(CommandScript.Packet([1, 2, 3], id));
        Assert.Equal(CommandScript.Packet([], id), await ReadAsync(socket, 16));
    }

    [Fact]
    public async Task Requests_are_answered_in_any_pieces_and_with_anything_between_them()
    {
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster);
        using Socket socket = Connect(server);
        byte[] request = CommandScript.Packet([2, 0, 0, 0], 1001);
        byte[] all = [.. request, 1, 2, 0xFF, .. request, .. request];
        foreach (byte value in all)
            socket.Send([value]);

        byte[] answer = CommandScript.Packet([1, 0, 0, 0], 1001);
        byte[] expected = [.. answer, .. answer, .. answer];
        Assert.Equal(expected, await ReadAsync(socket, 60));
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(int.MaxValue)]
    [InlineData(1025)]
    public async Task A_request_that_announces_too_much_closes_its_connection_and_no_other(int size)
    {
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster);
        using Socket socket = Connect(server);
        socket.Send(CommandScript.Packet([], 1004, size));
        Assert.Empty(await ReadAsync(socket, 1));

        using NeuronCommandClient client = CreateClient(server);
        Assert.Equal(RotationOrder.YXZ, await client.GetRotationOrderAsync().Soon());
    }

    [Fact]
    public async Task Parameters_that_are_too_short_name_no_avatar()
    {
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster);
        using Socket socket = Connect(server);
        socket.Send([.. CommandScript.Packet([0, 0], 1001), .. CommandScript.Packet([], 1004)]);
        byte[] expected = [.. CommandScript.Packet([0, 0, 0, 0], 1001), .. CommandScript.Packet([], 1004)];
        Assert.Equal(expected, await ReadAsync(socket, 36));
    }

    [Fact]
    public async Task Random_bytes_end_nothing()
    {
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster);
        var random = new Random(6);
        for (int i = 0; i < 30; i++)
        {
            using Socket socket = Connect(server);
            byte[] bytes = new byte[random.Next(1, 3000)];
            random.NextBytes(bytes);
            if (i % 2 == 0)
                CommandScript.Packet([], random.Next(65_536), random.Next(-10, 4000)).CopyTo(bytes.AsSpan(0, Math.Min(bytes.Length, 16)));
            socket.Send(bytes);
            if (i % 3 == 0)
                socket.LingerState = new LingerOption(enable: true, seconds: 0);
        }

        using NeuronCommandClient client = CreateClient(server);
        Assert.Equal(RotationOrder.YXZ, await client.GetRotationOrderAsync().Soon());
        await Limits.UntilAsync(() => server.ClientCount <= 1);
    }

    [Fact]
    public async Task Many_clients_are_served_at_once_and_those_beyond_the_limit_are_closed()
    {
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster, options => options.MaxClients = 8, getTimestamp: static () => 0);
        NeuronCommandClient[] clients = [.. Enumerable.Range(0, 8).Select(_ => CreateClient(server))];
        await Task.WhenAll(clients.Select(client => client.GetRotationOrderAsync())).Soon();
        await Limits.UntilAsync(() => server.ClientCount == 8);

        using Socket socket = Connect(server);
        Assert.Empty(await ReadAsync(socket, 1));
        foreach (NeuronCommandClient client in clients)
            client.Dispose();
        await Limits.UntilAsync(() => server.ClientCount == 0);
        using NeuronCommandClient next = CreateClient(server);
        await next.GetRotationOrderAsync().Soon();
    }

    // Idle connections cannot keep others out: whoever never asked gives way first, then whoever asked nothing for the longest time.
    [Fact]
    public async Task When_there_is_no_room_the_oldest_idle_client_gives_way()
    {
        long now = 0;
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster, options => options.MaxClients = 3, () => Volatile.Read(ref now));
        using NeuronCommandClient asked = CreateClient(server);
        await asked.GetRotationOrderAsync().Soon();
        Pass(10);
        using Socket first = Connect(server);
        await Limits.UntilAsync(() => server.ClientCount == 2);
        Pass(1);
        using Socket second = Connect(server);
        await Limits.UntilAsync(() => server.ClientCount == 3);

        // First has been idle for 4 seconds, second for 3: not for as long as the one that asked, which stays all the same.
        Pass(3);
        using NeuronCommandClient third = CreateClient(server);
        await third.GetRotationOrderAsync().Soon();
        await IsClosedAsync(first);
        Assert.Equal(3, server.ClientCount);
        using NeuronCommandClient fourth = CreateClient(server);
        await fourth.GetRotationOrderAsync().Soon();
        await IsClosedAsync(second);

        // Now all have asked, and the one that did so longest ago is the first.
        using Socket fifth = Connect(server);
        fifth.Send(CommandScript.Packet([], 1003));
        Assert.Equal(20, (await ReadAsync(fifth, 20)).Length);
        Assert.Equal(3, server.ClientCount);

        // Nobody of those that are left has been idle for long.
        using Socket sixth = Connect(server);
        Assert.Empty(await ReadAsync(sixth, 1));
        await third.GetRotationOrderAsync().Soon();
        await fourth.GetRotationOrderAsync().Soon();

        void Pass(int seconds) => Interlocked.Add(ref now, seconds * Stopwatch.Frequency);
    }

    [Fact]
    public async Task A_client_that_asks_nothing_for_too_long_is_closed_also_when_it_sends_bytes_that_are_no_request()
    {
        long now = 0;
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster, options => options.IdleTimeout = TimeSpan.FromHours(1), () => Volatile.Read(ref now));
        using Socket idle = Connect(server);
        using Socket active = Connect(server);
        byte[] request = CommandScript.Packet([], 1003);
        for (int i = 0; i < 3; i++)
        {
            active.Send(request);
            Assert.Equal(20, (await ReadAsync(active, 20)).Length);
            Interlocked.Add(ref now, 25 * 60 * Stopwatch.Frequency);
            idle.Send([0]);
        }

        Assert.Empty(await ReadAsync(idle, 1));
        active.Send(request);
        Assert.Equal(20, (await ReadAsync(active, 20)).Length);
    }

    [Fact]
    public async Task A_client_that_says_nothing_is_closed_after_the_idle_time()
    {
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster, options => options.IdleTimeout = TimeSpan.FromSeconds(1));
        using Socket idle = Connect(server);
        Assert.Empty(await ReadAsync(idle, 1));
        await Limits.UntilAsync(() => server.ClientCount == 0);
    }

    [Fact]
    public async Task Stopping_ends_clients_and_may_be_repeated()
    {
        using Broadcaster broadcaster = CreateBroadcaster();
        CommandServer server = Start(broadcaster, options => options.Quirks.Delay = TimeSpan.FromMinutes(5));
        using NeuronCommandClient client = CreateClient(server);
        Task call = client.GetRotationOrderAsync();
        await Limits.UntilAsync(() => server.ClientCount == 1);
        server.Stop();
        await server.DisposeAsync();
        server.Dispose();

        await CommandAnswerTests.FailsAsync(call, CommandFailure.Closed, "closed the connection");
        await CommandAnswerTests.FailsAsync(client.ConnectAsync(), CommandFailure.Refused, "refused");
        Assert.Throws<ObjectDisposedException>(server.Start);
    }

    [Fact]
    public void A_port_in_use_is_told()
    {
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer first = Start(broadcaster);
        using var second = new CommandServer(broadcaster, new CommandServerOptions { Port = first.LocalEndPoint!.Port });
        Assert.Contains("used by another program", Assert.Throws<BroadcasterException>(second.Start).Message, StringComparison.Ordinal);
        Assert.Throws<InvalidOperationException>(first.Start);
    }

    [Fact]
    public void Settings_out_of_range_are_refused()
    {
        using Broadcaster broadcaster = CreateBroadcaster();
        Assert.Throws<ArgumentNullException>(() => new CommandServer(null!));
        Refuses(static options => options.Port = -1, "Port");
        Refuses(static options => options.BindAddress = null!, "BindAddress");
        Refuses(static options => options.MaxClients = 0, "MaxClients");
        Refuses(static options => options.IdleTimeout = TimeSpan.Zero, "IdleTimeout");
        Refuses(static options => options.IdleTimeout = TimeSpan.FromDays(2), "IdleTimeout");
        Refuses(static options => options.Quirks = null!, "Quirks");
        Refuses(static options => options.Quirks.ReplyId = 65_536, "ReplyId");
        Refuses(static options => options.Quirks.PayloadSize = -1, "PayloadSize");
        Refuses(static options => options.Quirks.Answers = 17, "Answers");
        Refuses(static options => options.Quirks.Fragment = 0, "Fragment");
        Refuses(static options => options.Quirks.Delay = TimeSpan.FromHours(1), "Delay");

        void Refuses(Action<CommandServerOptions> change, string setting)
        {
            var options = new CommandServerOptions();
            change(options);
            Assert.Contains(setting, Assert.Throws<ArgumentException>(() => new CommandServer(broadcaster, options)).Message, StringComparison.Ordinal);
        }
    }

    internal static Broadcaster CreateBroadcaster(Action<BroadcasterOptions>? change = null)
    {
        var options = new BroadcasterOptions { Sources = [new SyntheticActor(), new SyntheticActor(avatar: 1), new SyntheticActor(avatar: 2)], Port = 0 };
        change?.Invoke(options);
        return new Broadcaster(options);
    }

    internal static CommandServer Start(Broadcaster broadcaster, Action<CommandServerOptions>? change = null, Func<long>? getTimestamp = null)
    {
        var options = new CommandServerOptions { Port = 0 };
        change?.Invoke(options);
        var server = new CommandServer(broadcaster, options) { GetTimestamp = getTimestamp ?? Stopwatch.GetTimestamp };
        server.Start();
        return server;
    }

    internal static NeuronCommandClient CreateClient(CommandServer server, Action<NeuronCommandOptions>? change = null)
    {
        var options = new NeuronCommandOptions { Port = server.LocalEndPoint!.Port, Timeout = Limits.Unexpected };
        change?.Invoke(options);
        return new NeuronCommandClient(options);
    }

    private static LoopedSource Still(float heading) => new(new BvhSource(BvhDocument.Parse(
        NeuronTake.Write(1, (_, bone) => bone == Bone.Hips ? new Vector3(heading, 5, -3) : default))));

    private static bool IsNear(ref double heading, double expected) => Math.Abs(Volatile.Read(ref heading) - expected) < 0.1;

    private static BoneTransform[] DefaultBody() =>
        [.. BoneHierarchy.Bones.ToArray().Select(bone => new BoneTransform(DefaultOffsets.Get(bone), Quaternion.Identity))];

    private static Socket Connect(CommandServer server)
    {
        var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp) { NoDelay = true };
        socket.Connect(new IPEndPoint(IPAddress.Loopback, server.LocalEndPoint!.Port));
        return socket;
    }

    // In good order, or by a reset where the system gives no other end to a connection that is being waited on.
    private static async Task IsClosedAsync(Socket socket)
    {
        try
        {
            Assert.Empty(await ReadAsync(socket, 1));
        }
        catch (SocketException exception)
        {
            Assert.Equal(SocketError.ConnectionReset, exception.SocketErrorCode);
        }
    }

    // Fewer when the server closes the connection first.
    private static async Task<byte[]> ReadAsync(Socket socket, int count)
    {
        byte[] bytes = new byte[count];
        int filled = 0;
        while (filled < count)
        {
            int read = await socket.ReceiveAsync(bytes.AsMemory(filled), SocketFlags.None).AsTask().Soon();
            if (read == 0)
                break;

            filled += read;
        }

        return bytes[..filled];
    }
}
