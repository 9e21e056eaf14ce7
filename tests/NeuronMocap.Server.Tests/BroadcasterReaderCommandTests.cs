using System.Buffers.Binary;
using NeuronMocap.Protocol;
using NeuronMocap.Server.Clients;
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

    [Fact]
    public async Task Registrations_are_repeated_on_the_next_connection()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options(reconnect: true));
        await using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0 });
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        using TestClient other = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        reader.Start();
        byte[] register = Register(DataCommandId.CombinationMode);
        byte[] cancelled = Register(DataCommandId.AvatarCount);
        byte[] ofGone = Register(DataCommandId.BoneSize);
        byte[] cancel = Requests.Create((int)DataCommandId.UnregisterEvent, (int)DataCommandId.AvatarCount);
        using (TestConnection first = await server.AcceptAsync())
        {
            await Limits.UntilAsync(() => reader.Status.IsConnected);
            await PassAsync(client, first, register);
            await PassAsync(client, first, cancelled);
            await PassAsync(other, first, ofGone);
            await PassAsync(client, first, cancel);
            other.Dispose();
            await SendUntilAsync(first, () => broadcaster.GetStatistics().Clients == 1);

            // The client that left has not cancelled its registration, so the relay does.
            byte[] unwanted = CancellationOf(ofGone);
            Assert.Equal(unwanted, await ReceiveAsync(first, unwanted.Length));
        }

        // The request behind the registration is that of the client, so no other registration is repeated.
        using TestConnection second = await server.AcceptAsync();
        Assert.Equal(register, await ReceiveAsync(second, register.Length));
        await PassAsync(client, second, Requests.Create((int)DataCommandId.AvatarCount, 0));
        Assert.Equal(0, broadcaster.GetStatistics().RequestsDropped);
    }

    [Fact]
    public async Task A_registration_that_has_no_connection_yet_waits_for_one()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        await using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0 });
        using TestClient client = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        byte[] register = Register(DataCommandId.CombinationMode);
        await client.Socket.SendAsync((byte[])[.. register, .. Requests.Create((int)DataCommandId.AvatarCount, 0)]);
        await Limits.UntilAsync(() => broadcaster.GetStatistics().RequestsDropped == 1);
        reader.Start();
        using TestConnection source = await server.AcceptAsync();
        Assert.Equal(register, await ReceiveAsync(source, register.Length));
    }

    [Fact]
    public async Task A_client_that_cancels_its_registration_leaves_that_of_another()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        await using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0 });
        using TestClient one = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        using TestClient two = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        reader.Start();
        using TestConnection source = await server.AcceptAsync();
        await Limits.UntilAsync(() => reader.Status.IsConnected);
        byte[] register = Register(DataCommandId.CombinationMode);
        byte[] cancel = Requests.Create((int)DataCommandId.UnregisterEvent, (int)DataCommandId.CombinationMode);
        await PassAsync(one, source, register);
        await PassAsync(two, source, register);

        // The server gets the request behind the first cancellation, but not the cancellation. It gets the second one.
        await one.Socket.SendAsync(cancel);
        await PassAsync(one, source, Requests.Create((int)DataCommandId.AvatarCount, 0));
        await PassAsync(two, source, cancel);
    }

    [Fact]
    public async Task The_last_client_of_a_value_cancels_it_when_it_leaves()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        await using Broadcaster broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = reader, Port = 0 });
        using TestClient one = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        using TestClient two = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        using TestClient three = await TestClient.ConnectAsync(broadcaster.LocalEndPoint, allowsCutEnd: true);
        reader.Start();
        using TestConnection source = await server.AcceptAsync();
        await Limits.UntilAsync(() => reader.Status.IsConnected);
        byte[] register = Register(DataCommandId.CombinationMode);
        await PassAsync(one, source, register);
        await PassAsync(two, source, register);
        one.Dispose();
        await SendUntilAsync(source, () => broadcaster.GetStatistics().Clients == 2);

        // The request of the third client is the next that the server gets, so the first client cancelled nothing.
        await PassAsync(three, source, Requests.Create((int)DataCommandId.AvatarCount, 0));
        two.Dispose();
        await SendUntilAsync(source, () => broadcaster.GetStatistics().Clients == 1);
        Assert.Equal(CancellationOf(register), await ReceiveAsync(source, register.Length));
        Assert.Equal(0, broadcaster.GetStatistics().RequestsDropped);
    }

    [Fact]
    public void Only_so_many_registrations_are_kept()
    {
        var registrations = new Registrations();
        object client = new();
        for (int value = 0; value < 1000; value++)
            Assert.Equal(value < 64, registrations.TryAdd(value, client, [(byte)value]));

        Assert.Equal(64, registrations.Requests.Count());
        Assert.True(registrations.Remove(63, client));
        Assert.True(registrations.Remove(64, client));
        Assert.Equal(63, registrations.Requests.Count());
        Assert.Equal(63, registrations.Forget(client).Count);
        Assert.Empty(registrations.Requests);
    }

    private static byte[] Register(DataCommandId id) => Requests.Create((int)DataCommandId.RegisterEvent, (int)id);

    // The registration with another command, which is the number at byte 14.
    private static byte[] CancellationOf(byte[] registration)
    {
        byte[] request = [.. registration];
        BinaryPrimitives.WriteInt32LittleEndian(request.AsSpan(14), (int)DataCommandId.UnregisterEvent);
        return request;
    }

    private static async Task PassAsync(TestClient client, TestConnection source, byte[] request)
    {
        await client.Socket.SendAsync(request);
        Assert.Equal(request, await ReceiveAsync(source, request.Length));
    }

    // A client that has left is noticed when something is sent to it.
    private static async Task SendUntilAsync(TestConnection source, Func<bool> condition)
    {
        while (!condition())
        {
            await source.SendAsync(TestPackets.Motion(0));
            await Task.Yield();
        }
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
