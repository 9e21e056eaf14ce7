using System.Net.Sockets;
using NeuronMocap.AspNetCore.Tests.Infrastructure;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.AspNetCore.Tests.WebSockets;

// Frames that are no messages, without an end.
public sealed class FloodTests
{
    private const byte Continuation = 0x00;
    private const byte Binary = 0x02;
    private const byte Ping = 0x89;

    [Theory]
    [InlineData(Ping, Ping)]
    [InlineData(Binary, Continuation)]
    public async Task A_flood_of_pings_or_empty_fragments_ends_the_connection(byte first, byte next)
    {
        await using MotionSite site = await MotionSite.StartAsync();
        using Socket client = await site.ConnectRawAsync();
        Task reading = ReadAsync(client);
        Task flooding = FloodAsync(client, first, next);
        await Limits.UntilAsync(() => site.Broadcaster.GetStatistics().Clients == 0);
        client.Dispose();
        await Task.WhenAll(reading, flooding).Soon();
    }

    [Fact]
    public async Task A_few_pings_are_answered()
    {
        await using MotionSite site = await MotionSite.StartAsync();
        using Socket client = await site.ConnectRawAsync();
        for (int i = 0; i < 10; i++)
            await client.SendAsync(EmptyFrame(Ping), TestContext.Current.CancellationToken).AsTask().Soon();

        await site.Motion.SendAsync(TestPackets.Motion(1));
        await Limits.UntilAsync(() => site.Broadcaster.GetStatistics() is { Clients: 1, FramesSent: 1 });
    }

    // Masked, without bytes.
    private static byte[] EmptyFrame(byte kind) => [kind, 0x80, 0, 0, 0, 0];

    private static async Task FloodAsync(Socket client, byte first, byte next)
    {
        byte[] flood = [.. Enumerable.Repeat(EmptyFrame(next), 200).SelectMany(static frame => frame)];
        try
        {
            await client.SendAsync(EmptyFrame(first), TestContext.Current.CancellationToken);
            while (true)
                await client.SendAsync(flood, TestContext.Current.CancellationToken);
        }
        catch (Exception exception) when (exception is SocketException or ObjectDisposedException)
        {
            // The server has ended the connection.
        }
    }

    // Whoever floods and does not read is a slow client.
    private static async Task ReadAsync(Socket client)
    {
        byte[] buffer = new byte[4096];
        try
        {
            while (await client.ReceiveAsync(buffer, TestContext.Current.CancellationToken) > 0)
            {
            }
        }
        catch (Exception exception) when (exception is SocketException or ObjectDisposedException)
        {
            // The server has ended the connection.
        }
    }
}
