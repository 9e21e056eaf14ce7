using System.Net.Sockets;
using NeuronMocap.Tests.Server;
using static NeuronMocap.Server.Tests.Broadcasts;

namespace NeuronMocap.Server.Tests;

// Clients that misbehave, at both kinds of rate, each beside a client that must not be affected.
public sealed class BroadcasterClientTests
{
    private const int Frames = 4000;

    [Theory]
    [InlineData(BroadcasterOptions.MaxFrameRate)]
    [InlineData(200)]
    public async Task A_client_that_resets_is_forgotten(double rate)
    {
        BroadcasterOptions options = EndlessOptions(rate);
        await using Broadcaster broadcaster = Started(options);
        using TestClient witness = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        TestClient rude = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        await rude.ReadAsync();
        rude.Reset();

        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 1);
        await AssertGetsFramesAsync(witness, options);
    }

    [Theory]
    [InlineData(BroadcasterOptions.MaxFrameRate)]
    [InlineData(2000)]
    public async Task A_client_that_closes_its_sending_side_still_gets_everything(double rate)
    {
        BroadcasterOptions options = Options(rate);
        await using Broadcaster broadcaster = Started(options);
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        client.Socket.Shutdown(SocketShutdown.Send);

        await AssertGetsTheRestAsync(client, (await client.ReadAsync())!, options);
        await broadcaster.Completion.Soon();
    }

    [Theory]
    [InlineData(BroadcasterOptions.MaxFrameRate)]
    [InlineData(2000)]
    public async Task Data_from_clients_is_discarded(double rate)
    {
        BroadcasterOptions options = Options(rate);
        await using Broadcaster broadcaster = Started(options);
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);

        // More than the system buffers for a server that does not read.
        await client.Socket.SendAsync(new byte[20_000_000], TestContext.Current.CancellationToken).Soon();
        byte[] first = (await client.ReadAsync())!;
        await client.Socket.SendAsync(new byte[1000], TestContext.Current.CancellationToken).Soon();
        await AssertGetsTheRestAsync(client, first, options);
    }

    [Theory]
    [InlineData(BroadcasterOptions.MaxFrameRate)]
    [InlineData(200)]
    public async Task A_flood_of_short_connections_does_not_affect_other_clients(double rate)
    {
        BroadcasterOptions options = EndlessOptions(rate);
        await using Broadcaster broadcaster = Started(options);
        using TestClient witness = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        for (int i = 0; i < 200; i++)
        {
            TestClient visitor = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
            if (i % 2 == 0)
                visitor.Reset();
            else
                visitor.Dispose();
        }

        await AssertGetsFramesAsync(witness, options);
    }

    [Fact]
    public async Task More_clients_than_allowed_are_refused_until_one_leaves()
    {
        BroadcasterOptions options = Expect.Options();
        options.FrameRate = 100;
        options.MaxClients = 2;
        await using Broadcaster broadcaster = Started(options);
        using TestClient first = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        using TestClient second = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        await first.ReadAsync();
        await second.ReadAsync();
        using (TestClient third = await TestClient.ConnectAsync(broadcaster.LocalEndPoint))
            Assert.Null(await third.ReadAsync());

        BroadcasterStatistics statistics = broadcaster.GetStatistics();
        Assert.Equal((2, 2, 1), (statistics.Clients, statistics.Accepted, statistics.Refused));
        second.Dispose();
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 1);
        using TestClient fourth = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        Assert.NotNull(await fourth.ReadAsync());
    }

    private static BroadcasterOptions Options(double rate)
    {
        BroadcasterOptions options = Expect.Options();
        options.FrameRate = rate;
        options.WaitForClient = true;
        options.MaxFrames = double.IsPositiveInfinity(rate) ? Frames : Frames / 4;
        options.QueueCapacity = Frames;
        return options;
    }

    // The broadcast does not end before the witness has read, and does not overwrite the witness's data, however long the test takes.
    private static BroadcasterOptions EndlessOptions(double rate)
    {
        BroadcasterOptions options = Options(rate);
        options.MaxFrames = null;
        options.QueueCapacity = 20_000;
        return options;
    }

    private static async Task AssertGetsTheRestAsync(TestClient client, byte[] first, BroadcasterOptions options)
    {
        List<byte[]> rest = await client.ReadToEndAsync();
        Expect.Frames([first, .. rest], options, options.MaxFrames!.Value);
        client.Dispose();
    }

    private static async Task AssertGetsFramesAsync(TestClient client, BroadcasterOptions options)
    {
        var packets = new List<byte[]>();
        while (packets.Count < 100)
            packets.Add((await client.ReadAsync())!);

        Expect.Frames(packets, options, packets.Count);
    }
}
