using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Server;

namespace NeuronMocap.Server.Tests;

// The commands of clients, passed to the server of a reader.
public sealed class BroadcasterReaderCommandTests
{
    [Fact]
    public async Task Requests_go_to_the_server_and_replies_to_all_clients()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        await using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0 });
        reader.Start();
        using TestConnection source = await server.AcceptAsync();
        using TestClient asking = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        using TestClient other = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        await Limits.UntilAsync(() => broadcaster.GetStatistics().Clients == 2);
        await Limits.UntilAsync(() => reader.Status.IsConnected);

        byte[] request = Requests.Create(id: 12, parameter: 3);
        await asking.Socket.SendAsync(request);
        Assert.Equal(request, await ReceiveAsync(source, request.Length));

        byte[] reply = Requests.Create(id: 12, parameter: 4);
        await source.SendAsync(reply);
        Assert.Equal(reply, await asking.ReadAsync());
        Assert.Equal(reply, await other.ReadAsync());
        Assert.Equal(0, broadcaster.GetStatistics().RequestsDropped);
    }

    [Fact]
    public async Task Requests_without_a_connection_are_counted()
    {
        await using var reader = new NeuronReader("127.0.0.1");
        await using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0 });
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        await client.Socket.SendAsync((byte[])[.. Requests.Create(1, 0), .. Requests.Create(2, 0)]);
        await Limits.UntilAsync(() => broadcaster.GetStatistics().RequestsDropped == 2);
    }

    [Fact]
    public async Task Requests_stay_here_if_they_are_not_to_be_answered()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        await using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0, AnswerDataCommands = false });
        reader.Start();
        using TestConnection source = await server.AcceptAsync();
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint);
        await Limits.UntilAsync(() => reader.Status.IsConnected && broadcaster.GetStatistics().Clients == 1);
        await client.Socket.SendAsync(Requests.Create(0, 0));
        await source.SendAsync(TestPackets.Motion(0));
        Assert.Equal(TestPackets.Motion(0), await client.ReadAsync());

        // The reader's own request is the first that the server receives.
        reader.DataCommands.TryRequest(DataCommandId.AvatarCount);
        Assert.True(DataCommandHeader.TryRead(await ReceiveAsync(source, 64), out DataCommandHeader header));
        Assert.Equal(DataCommandId.AvatarCount, header.CommandId);
    }

    private static async Task<byte[]> ReceiveAsync(TestConnection connection, int length)
    {
        byte[] bytes = new byte[length];
        for (int received = 0; received < length;)
        {
            int count = await connection.Socket.ReceiveAsync(bytes.AsMemory(received), TestContext.Current.CancellationToken).Soon();
            Assert.NotEqual(0, count);
            received += count;
        }

        return bytes;
    }
}
