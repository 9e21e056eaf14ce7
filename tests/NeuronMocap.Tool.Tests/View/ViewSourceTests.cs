using System.Net;
using System.Net.Sockets;
using System.Text.Json;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tool.Tests.Infrastructure;

namespace NeuronMocap.Tool.Tests.View;

// Sources that come, go, and are wrong.
public sealed class ViewSourceTests
{
    [Fact]
    public async Task A_source_that_dies_and_comes_back_is_told_and_shown_again()
    {
        int port = FreePort.Next();
        await using RunningView view = await RunningView.StartAsync($"127.0.0.1:{port}");
        using ViewSocket control = await view.ConnectAsync("/control");
        JsonElement missing = await control.FindAsync("status", static status => status.GetProperty("state").ValueEquals("waiting"));
        Assert.Equal("Connection refused", missing.GetProperty("words").GetString());
        Assert.Contains($"{port}", missing.GetProperty("advice").GetString(), StringComparison.Ordinal);

        await using (Broadcaster first = StartServer(port))
        {
            await control.FindAsync("performer");
            await control.FindAsync("status", IsReceiving);
        }

        JsonElement lost = await control.FindAsync("status", static status => !IsReceiving(status));
        Assert.NotEmpty(lost.GetProperty("advice").GetString()!);
        await using Broadcaster second = StartServer(port);
        JsonElement back = await control.FindAsync("status", IsReceiving);
        Assert.True(back.GetProperty("reconnects").GetInt64() > 0);
        using ViewSocket motion = await view.ConnectAsync("/motion", "pose");
        Assert.NotNull(await motion.ReceiveAsync());
    }

    [Fact]
    public async Task Several_performers_have_keys_numbers_and_colours_of_their_own()
    {
        await using Broadcaster broadcaster = Broadcaster.StartDemo(avatars: 3);
        await using RunningView view = await RunningView.StartAsync(broadcaster.LocalEndPoint!.ToString());
        using ViewSocket control = await view.ConnectAsync("/control");
        var performers = new Dictionary<string, JsonElement>(StringComparer.Ordinal);
        while (performers.Count < 3)
        {
            JsonElement performer = await control.FindAsync("performer");
            performers[performer.GetProperty("key").GetString()!] = performer;
        }

        Assert.Equal(["0-0", "0-1", "0-2"], performers.Keys.Order(StringComparer.Ordinal));
        Assert.Equal(3, performers.Values.Select(static performer => performer.GetProperty("index").GetInt32()).Distinct().Count());
        Assert.Equal(3, performers.Values.Select(static performer => performer.GetProperty("colour").GetString()).Distinct(StringComparer.Ordinal).Count());
        using ViewSocket motion = await view.ConnectAsync("/motion", "pose");
        var seen = new HashSet<int>();
        while (seen.Count < 3)
            seen.Add(BitConverter.ToInt32((await motion.ReceiveAsync())!, 4));
    }

    [Fact]
    public async Task Two_senders_with_the_same_avatar_are_two_performers()
    {
        // Only there has this computer a second address for loopback.
        Assert.SkipUnless(OperatingSystem.IsLinux(), "This system has only one loopback address.");
        int port = FreePort.Next();
        await using RunningView view = await RunningView.StartAsync($"udp://127.0.0.1:{port}");
        using ViewSocket control = await view.ConnectAsync("/control");
        using ViewSocket motion = await view.ConnectAsync("/motion", "pose");
        using var stop = CancellationTokenSource.CreateLinkedTokenSource(TestContext.Current.CancellationToken);
        Task sending = Task.WhenAll(SendAsync("127.0.0.1", port, stop.Token), SendAsync("127.0.0.2", port, stop.Token));
        JsonElement first = await control.FindAsync("performer", static performer => performer.GetProperty("key").ValueEquals("0-0"));
        JsonElement second = await control.FindAsync("performer", static performer => performer.GetProperty("key").ValueEquals("1-0"));
        int[] numbers = [first.GetProperty("index").GetInt32(), second.GetProperty("index").GetInt32()];
        Assert.Equal(0, numbers[0]);
        Assert.NotEqual(0, numbers[1]);
        var seen = new HashSet<int>();
        while (seen.Count < 2)
            seen.Add(BitConverter.ToInt32((await motion.ReceiveAsync())!, 4));

        Assert.Equal(numbers.Order(), seen.Order());
        await stop.CancelAsync();
        await sending;
    }

    [Fact]
    public async Task Frames_without_a_skeleton_are_explained()
    {
        using FrameServer server = FrameServer.Pacing(static number => FrameServer.Motion((uint)number, 1, 2, 3));
        await using RunningView view = await RunningView.StartAsync(server.Address);
        using ViewSocket control = await view.ConnectAsync("/control");
        JsonElement status = await control.FindAsync("status", static status => status.GetProperty("words").ValueEquals("Frames without a skeleton"));
        Assert.StartsWith("A frame has 3 values.", status.GetProperty("advice").GetString(), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Values_that_are_not_finite_reach_no_page()
    {
        float[] values = [.. Enumerable.Repeat(float.NaN, 354)];
        using FrameServer server = FrameServer.Pacing(number => FrameServer.Motion((uint)number, values));
        await using RunningView view = await RunningView.StartAsync(server.Address);
        using ViewSocket control = await view.ConnectAsync("/control");
        JsonElement performer = await control.FindAsync("performer");
        Assert.Equal(BoneHierarchy.BoneCount, performer.GetProperty("bones").GetArrayLength());
        await control.FindAsync("status");
        await control.FindAsync("status");
    }

    private static bool IsReceiving(JsonElement status) => status.GetProperty("state").ValueEquals("receiving");

    private static Broadcaster StartServer(int port)
    {
        var broadcaster = new Broadcaster(new BroadcasterOptions { Sources = [new SyntheticSource()], BindAddress = IPAddress.Loopback, Port = port });
        broadcaster.Start();
        return broadcaster;
    }

    private static async Task SendAsync(string from, int port, CancellationToken cancellationToken)
    {
        using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        socket.Bind(new IPEndPoint(IPAddress.Parse(from), 0));
        for (uint index = 0; !cancellationToken.IsCancellationRequested; index++)
        {
            socket.SendTo(Poses.Upright(index: index, avatar: 0).Packet.ToArray(), new IPEndPoint(IPAddress.Loopback, port));
            await Task.Delay(5, cancellationToken).ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
        }
    }
}
