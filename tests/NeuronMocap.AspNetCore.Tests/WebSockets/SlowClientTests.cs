using System.Net.Sockets;
using System.Net.WebSockets;
using System.Text;
using Microsoft.AspNetCore.Builder;
using NeuronMocap.AspNetCore.Tests.Infrastructure;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.AspNetCore.Tests.WebSockets;

// What waits for clients that do not read, and how they end.
public sealed class SlowClientTests
{
    private static readonly WebSocketBroadcasterOptions Patient = new() { ClientTimeout = TimeSpan.FromHours(1) };

    [Fact]
    public async Task A_client_that_pauses_finds_few_old_frames()
    {
        await using MotionSite site = await MotionSite.StartAsync(Patient);
        using Socket client = await site.ConnectRawAsync();
        await site.FillAsync();

        // Kestrel and the system hold these. Without limits they hold hundreds. Everything else that waits is new.
        Assert.InRange(Assert.Single(site.Broadcaster.GetClients()).FramesSent, 1, 60);
    }

    [Fact]
    public async Task The_end_does_not_wait_for_a_client_that_never_reads()
    {
        await using MotionSite site = await MotionSite.StartAsync(Patient);
        using Socket client = await site.ConnectRawAsync();
        await site.FillAsync();
        await site.Broadcaster.DisposeAsync().AsTask().Soon();
        Assert.Equal(0, site.Broadcaster.GetStatistics().Clients);
    }

    [Fact]
    public async Task A_client_that_only_reads_sees_the_end_and_no_reset()
    {
        await using MotionSite site = await MotionSite.StartAsync(Patient);
        using Socket client = await site.ConnectRawAsync();
        Task<string> reading = ReadToEndAsync(client);
        await site.Broadcaster.DisposeAsync().AsTask().Soon();
        Assert.EndsWith("The server stops.", await reading, StringComparison.Ordinal);
    }

    [Fact]
    public async Task An_error_of_the_encoder_ends_the_clients_and_is_reported()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        await using var broadcaster = new WebSocketBroadcaster(reader, options: null, static (_, _) => throw new FormatException("no such frame"));
        reader.Start();
        using TestConnection motion = await server.AcceptAsync();
        await using WebServer web = await WebServer.StartAsync(map: application => application.MapNeuronWebSocket("/motion", broadcaster));
        using var client = new ClientWebSocket();
        await client.ConnectAsync(new Uri($"ws://127.0.0.1:{web.Port}/motion"), TestContext.Current.CancellationToken).Soon();
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 1);
        await motion.SendAsync(TestPackets.Motion(1));
        Assert.Equal((WebSocketCloseStatus.InternalServerError, "The server has failed."), await client.ReadToEndAsync());
        Assert.Equal("no such frame", (await Assert.ThrowsAsync<FormatException>(() => broadcaster.Completion.Soon())).Message);
        await broadcaster.DisposeAsync().AsTask().Soon();
    }

    [Fact]
    public async Task The_end_of_the_stream_is_an_ordinary_end()
    {
        await using MotionSite site = await MotionSite.StartAsync();
        Assert.False(site.Broadcaster.Completion.IsCompleted);
        await site.Reader.DisposeAsync();
        await site.Broadcaster.Completion.Soon();
    }

    private static async Task<string> ReadToEndAsync(Socket client)
    {
        byte[] buffer = new byte[4096];
        var text = new StringBuilder();
        int count;
        while ((count = await client.ReceiveAsync(buffer, TestContext.Current.CancellationToken).Soon()) > 0)
            text.Append(Encoding.ASCII.GetString(buffer, 0, count));

        return text.ToString();
    }
}
