using System.Net.Sockets;
using System.Net.WebSockets;
using System.Text;
using NeuronMocap.AspNetCore.Tests.Infrastructure;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.AspNetCore.Tests.WebSockets;

// Clients that are slow, many or hostile, and ends.
public sealed class WebSocketClientTests
{
    [Fact]
    public async Task A_client_that_never_reads_loses_its_own_frames_and_is_dropped()
    {
        // The other client is not read either while the system is busy, so the limit is long.
        await using MotionSite site = await MotionSite.StartAsync(new WebSocketBroadcasterOptions { ClientTimeout = TimeSpan.FromSeconds(5) });
        using Socket sleeper = await site.ConnectRawAsync();
        using ClientWebSocket reader = await site.ConnectAsync("packet");
        Task<(WebSocketCloseStatus?, string?)> reading = reader.ReadToEndAsync();
        await site.FillAsync();
        Assert.True(site.Broadcaster.GetStatistics().FramesDropped > 0);
        await Limits.UntilAsync(() => site.Broadcaster.GetStatistics().Clients == 1);

        WebSocketClientStatistics before = Assert.Single(site.Broadcaster.GetClients());
        Assert.Equal(WebSocketForm.Packet, before.Form);
        await site.Motion.SendAsync(TestPackets.Motion(1));
        await Limits.UntilAsync(() => site.Broadcaster.GetClients()[0] is var now && now.FramesSent + now.FramesDropped > before.FramesSent + before.FramesDropped);
        await site.Reader.DisposeAsync();
        Assert.Equal((WebSocketCloseStatus.EndpointUnavailable, "The stream has ended."), await reading);
    }

    [Fact]
    public async Task Every_frame_is_sent_or_counted_for_each_of_fifty_clients()
    {
        const int Clients = 50;
        const int Frames = 200;
        await using MotionSite site = await MotionSite.StartAsync();
        var clients = new List<ClientWebSocket>();
        for (int i = 0; i < Clients; i++)
            clients.Add(await site.ConnectAsync(i % 2 == 0 ? "packet" : "pose"));

        Task<(WebSocketCloseStatus?, string?)>[] reading = [.. clients.Select(static client => client.ReadToEndAsync())];
        for (int frame = 0; frame < Frames; frame++)
            await site.Motion.SendAsync(TestPackets.Motion(frame));

        await site.UntilHandledAsync(Clients * Frames);
        WebSocketBroadcasterStatistics total = site.Broadcaster.GetStatistics();
        Assert.Equal(Clients * Frames, total.FramesSent + total.FramesDropped + total.FramesSkipped + (Clients * total.FramesMissed));
        Assert.Equal(total.FramesSent, site.Broadcaster.GetClients().Sum(static client => client.FramesSent));
        Assert.All(site.Broadcaster.GetClients(), static client => Assert.InRange(client.FramesSent, 1, Frames));
        await site.Reader.DisposeAsync();
        Assert.All(await Task.WhenAll(reading), static end => Assert.Equal("The stream has ended.", end.Item2));
        clients.ForEach(static client => client.Dispose());
        await Limits.UntilAsync(() => site.Broadcaster.GetStatistics().Clients == 0);
        Assert.Equal(total.FramesSent, site.Broadcaster.GetStatistics().FramesSent);
    }

    [Fact]
    public async Task A_rate_leaves_frames_out_and_counts_them()
    {
        await using MotionSite site = await MotionSite.StartAsync(new WebSocketBroadcasterOptions { MaxRate = 500 });
        using ClientWebSocket client = await site.ConnectAsync("packet", "?rate=0.01");
        using ClientWebSocket fast = await site.ConnectAsync("packet", "?rate=900");
        Assert.Equal([0.01, 500], site.Broadcaster.GetClients().Select(static each => each.MaxRate));
        await site.Motion.SendAsync(TestPackets.Motions(1, 100));
        await Limits.UntilAsync(() => site.Broadcaster.GetClients()[0] is { FramesSent: 1, FramesSkipped: 99 });
        Assert.Equal(TestPackets.Motion(1), await client.ReadBinaryAsync());
    }

    [Fact]
    public async Task A_flood_of_messages_ends_the_connection_with_a_reason()
    {
        await using MotionSite site = await MotionSite.StartAsync();
        using ClientWebSocket client = await site.ConnectAsync();
        Task<(WebSocketCloseStatus?, string?)> reading = client.ReadToEndAsync();
        try
        {
            while (!reading.IsCompleted)
                await client.SendAsync(new byte[10], WebSocketMessageType.Binary, endOfMessage: true, TestContext.Current.CancellationToken).Soon();
        }
        catch (WebSocketException)
        {
            // The server has closed the connection meanwhile.
        }

        Assert.Equal((WebSocketCloseStatus.PolicyViolation, "A client sends at most 100 messages in a second."), await reading);
    }

    [Fact]
    public async Task A_long_message_ends_the_connection_with_a_reason()
    {
        await using MotionSite site = await MotionSite.StartAsync();
        using ClientWebSocket client = await site.ConnectAsync();
        await client.SendAsync(new byte[3000], WebSocketMessageType.Binary, endOfMessage: false, TestContext.Current.CancellationToken).Soon();
        await client.SendAsync(new byte[3000], WebSocketMessageType.Binary, endOfMessage: true, TestContext.Current.CancellationToken).Soon();
        Assert.Equal((WebSocketCloseStatus.MessageTooBig, "A message of a client has at most 4096 bytes."), await client.ReadToEndAsync());
    }

    [Fact]
    public async Task A_few_messages_are_ignored()
    {
        await using MotionSite site = await MotionSite.StartAsync();
        using ClientWebSocket client = await site.ConnectAsync("packet");
        await client.SendAsync(new byte[4096], WebSocketMessageType.Text, endOfMessage: true, TestContext.Current.CancellationToken).Soon();
        await site.Motion.SendAsync(TestPackets.Motion(1));
        Assert.Equal(TestPackets.Motion(1), await client.ReadBinaryAsync());
    }

    [Fact]
    public async Task Garbage_in_place_of_frames_ends_only_its_connection()
    {
        await using MotionSite site = await MotionSite.StartAsync();
        using ClientWebSocket other = await site.ConnectAsync("packet");
        using Socket hostile = await site.ConnectRawAsync();
        await hostile.SendAsync(Encoding.ASCII.GetBytes(new string('x', 1000)), TestContext.Current.CancellationToken).AsTask().Soon();
        await Limits.UntilAsync(() => site.Broadcaster.GetStatistics().Clients == 1);
        await site.Motion.SendAsync(TestPackets.Motion(1));
        Assert.Equal(TestPackets.Motion(1), await other.ReadBinaryAsync());
    }

    [Fact]
    public async Task The_end_of_the_application_ends_the_clients()
    {
        await using MotionSite site = await MotionSite.StartAsync();
        using ClientWebSocket client = await site.ConnectAsync();
        Task stopping = site.Web.StopAsync();
        Assert.Equal((WebSocketCloseStatus.EndpointUnavailable, "The server stops."), await client.ReadToEndAsync());
        await client.CloseOutputAsync(WebSocketCloseStatus.NormalClosure, null, TestContext.Current.CancellationToken).Soon();
        await stopping;
    }

    [Fact]
    public async Task A_broadcaster_that_is_disposed_refuses_and_says_goodbye()
    {
        await using MotionSite site = await MotionSite.StartAsync();
        using ClientWebSocket client = await site.ConnectAsync();
        Task disposing = site.Broadcaster.DisposeAsync().AsTask();
        Assert.Equal((WebSocketCloseStatus.EndpointUnavailable, "The server stops."), await client.ReadToEndAsync());
        await client.CloseOutputAsync(WebSocketCloseStatus.NormalClosure, null, TestContext.Current.CancellationToken).Soon();
        await disposing.Soon();
        using var late = new ClientWebSocket();
        await Assert.ThrowsAsync<WebSocketException>(() => late.ConnectAsync(new Uri(site.Address), TestContext.Current.CancellationToken).Soon());
    }
}
