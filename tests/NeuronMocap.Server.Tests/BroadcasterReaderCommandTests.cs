using System.Buffers.Binary;
using NeuronMocap.Protocol;
using NeuronMocap.Server.Clients;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Server;
using static NeuronMocap.Server.Tests.RelayedCommands;

namespace NeuronMocap.Server.Tests;

// The commands of clients, passed to the server of a reader.
public sealed class BroadcasterReaderCommandTests
{
    [Fact]
    public async Task Requests_go_to_the_server_and_replies_to_all_clients()
    {
        await using var relay = new RelayedCommands();
        TestClient asking = await relay.ConnectAsync();
        TestClient other = await relay.ConnectAsync();
        TestConnection source = await relay.StartAsync();
        await PassAsync(asking, source, Requests.Create(id: 12, parameter: 3));

        byte[] reply = Requests.Create(id: 12, parameter: 4);
        await source.SendAsync(reply);
        Assert.Equal(reply, await asking.ReadAsync());
        Assert.Equal(reply, await other.ReadAsync());
        Assert.Equal(0, relay.Statistics.RequestsDropped);
    }

    [Fact]
    public async Task Requests_without_a_connection_are_counted()
    {
        await using var relay = new RelayedCommands();
        TestClient client = await relay.ConnectAsync();
        await client.Socket.SendAsync((byte[])[.. Requests.Create(1, 0), .. Requests.Create(2, 0)]);
        await Limits.UntilAsync(() => relay.Statistics.RequestsDropped == 2);
    }

    [Fact]
    public async Task Requests_stay_here_if_they_are_not_to_be_answered()
    {
        await using var relay = new RelayedCommands(answersDataCommands: false);
        TestClient client = await relay.ConnectAsync();
        TestConnection source = await relay.StartAsync();
        await client.Socket.SendAsync(Requests.Create(0, 0));
        await source.SendAsync(TestPackets.Motion(0));
        Assert.Equal(TestPackets.Motion(0), await client.ReadAsync());

        // The reader's own request is the first that the server receives.
        relay.Reader.DataCommands.TryRequest(DataCommandId.AvatarCount);
        Assert.True(DataCommandHeader.TryRead(await ReceiveAsync(source, 64), out DataCommandHeader header));
        Assert.Equal(DataCommandId.AvatarCount, header.CommandId);
    }

    [Fact]
    public async Task Registrations_are_repeated_on_the_next_connection()
    {
        await using var relay = new RelayedCommands(reconnect: true);
        TestClient client = await relay.ConnectAsync();
        TestClient other = await relay.ConnectAsync();
        byte[] register = Register(DataCommandId.CombinationMode);
        byte[] cancelled = Register(DataCommandId.AvatarCount);
        byte[] ofGone = Register(DataCommandId.BoneSize);
        byte[] cancel = Requests.Create((int)DataCommandId.UnregisterEvent, (int)DataCommandId.AvatarCount);
        using (TestConnection first = await relay.StartAsync())
        {
            await PassAsync(client, first, register);
            await PassAsync(client, first, cancelled);
            await PassAsync(other, first, ofGone);
            await PassAsync(client, first, cancel);
            await relay.LeaveAsync(other, first);

            // The client that left has not cancelled its registration, so the relay does.
            byte[] unwanted = CancellationOf(ofGone);
            Assert.Equal(unwanted, await ReceiveAsync(first, unwanted.Length));
        }

        // The request behind the registration is that of the client, so no other registration is repeated.
        TestConnection second = await relay.AcceptAsync();
        Assert.Equal(register, await ReceiveAsync(second, register.Length));
        await PassAsync(client, second, Requests.Create((int)DataCommandId.AvatarCount, 0));
        Assert.Equal(0, relay.Statistics.RequestsDropped);
    }

    [Fact]
    public async Task A_registration_that_has_no_connection_yet_waits_for_one()
    {
        await using var relay = new RelayedCommands();
        TestClient client = await relay.ConnectAsync();
        byte[] register = Register(DataCommandId.CombinationMode);
        await client.Socket.SendAsync((byte[])[.. register, .. Requests.Create((int)DataCommandId.AvatarCount, 0)]);
        await Limits.UntilAsync(() => relay.Statistics.RequestsDropped == 1);
        TestConnection source = await relay.StartAsync();
        Assert.Equal(register, await ReceiveAsync(source, register.Length));
    }

    [Fact]
    public async Task A_client_that_cancels_its_registration_leaves_that_of_another()
    {
        await using var relay = new RelayedCommands();
        TestClient one = await relay.ConnectAsync();
        TestClient two = await relay.ConnectAsync();
        TestConnection source = await relay.StartAsync();
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
        await using var relay = new RelayedCommands();
        TestClient one = await relay.ConnectAsync();
        TestClient two = await relay.ConnectAsync();
        TestClient three = await relay.ConnectAsync();
        TestConnection source = await relay.StartAsync();
        byte[] register = Register(DataCommandId.CombinationMode);
        await PassAsync(one, source, register);
        await PassAsync(two, source, register);
        await relay.LeaveAsync(one, source);

        // The request of the third client is the next that the server gets, so the first client cancelled nothing.
        await PassAsync(three, source, Requests.Create((int)DataCommandId.AvatarCount, 0));
        await relay.LeaveAsync(two, source);
        Assert.Equal(CancellationOf(register), await ReceiveAsync(source, register.Length));
        Assert.Equal(0, relay.Statistics.RequestsDropped);
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
}
