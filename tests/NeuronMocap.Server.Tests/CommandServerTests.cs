using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Commands;
using NeuronMocap.Protocol;
using NeuronMocap.Server.Tests.Sources;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Bvh;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Server.Sources;

namespace NeuronMocap.Server.Tests;

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
            options.IncludeDisplacement = displacement;
            options.IncludeReference = reference;
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
    public async Task The_body_of_a_take_is_reported()
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
    public async Task An_unknown_avatar_gets_an_empty_answer()
    {
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster);
        using NeuronCommandClient client = CreateClient(server);
        await CommandCall.FailsAsync(client.ZeroOutAsync(3), CommandFailure.Rejected, "avatar 3");
        await CommandCall.FailsAsync(client.GetBoneDimensionsAsync(3), CommandFailure.Rejected, "avatar 3");
        await CommandCall.FailsAsync(client.GetBvhHeaderAsync(int.MaxValue), CommandFailure.Rejected, "avatar 2147483647");
        await client.ZeroOutAsync(2).Soon();
    }

    [Fact]
    public async Task A_zero_out_turns_only_its_avatar_to_the_front()
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
        reader.MotionReceived += frame => Volatile.Write(ref headings[frame.AvatarIndex], ZeroOutSourceTests.Heading(frame[Bone.Hips]));
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
    public async Task A_handler_on_the_receive_thread_may_send_commands()
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
    public async Task Type_and_reserved_field_of_a_request_are_ignored()
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
    public async Task An_unknown_command_gets_an_empty_answer(int id)
    {
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster);
        using Socket socket = Connect(server);
        socket.Send(CommandScript.Packet([1, 2, 3], id));
        Assert.Equal(CommandScript.Packet([], id), await ReadAsync(socket, 16));
    }

    [Fact]
    public async Task Requests_in_any_pieces_with_noise_between_are_answered()
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

    [Fact]
    public async Task Short_parameters_name_no_avatar()
    {
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster);
        using Socket socket = Connect(server);
        socket.Send([.. CommandScript.Packet([0, 0], 1001), .. CommandScript.Packet([], 1004)]);
        byte[] expected = [.. CommandScript.Packet([0, 0, 0, 0], 1001), .. CommandScript.Packet([], 1004)];
        Assert.Equal(expected, await ReadAsync(socket, 36));
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

        await CommandCall.FailsAsync(call, CommandFailure.Closed, "closed the connection");
        await CommandCall.FailsAsync(client.ConnectAsync(), CommandFailure.Refused, "refused");
        Assert.Throws<ObjectDisposedException>(server.Start);
    }

    [Fact]
    public void A_port_in_use_is_reported()
    {
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer first = Start(broadcaster);
        using var second = new CommandServer(broadcaster, new CommandServerOptions { Port = first.LocalEndPoint!.Port });
        Assert.Contains("in use by another program", Assert.Throws<BroadcasterException>(second.Start).Message, StringComparison.Ordinal);
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
        var options = new BroadcasterOptions { Sources = [new SyntheticSource(), new SyntheticSource(avatarIndex: 1), new SyntheticSource(avatarIndex: 2)], Port = 0 };
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

    internal static Socket Connect(CommandServer server)
    {
        var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp) { NoDelay = true };
        socket.Connect(new IPEndPoint(IPAddress.Loopback, server.LocalEndPoint!.Port));
        return socket;
    }

    // Closed gracefully, or by a reset if the system cannot otherwise end a connection that is being waited on.
    internal static async Task IsClosedAsync(Socket socket)
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

    // Returns fewer bytes if the server closes the connection first.
    internal static async Task<byte[]> ReadAsync(Socket socket, int count)
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
