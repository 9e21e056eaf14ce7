using NeuronMocap.Tests.Network;

namespace NeuronMocap.Server.Tests;

/// <summary>Three connections in a row: a server that the test writes, a reader with a broadcaster, and clients of the broadcaster.</summary>
internal sealed class RelayedCommands : IAsyncDisposable
{
    private readonly TestServer _server = new();
    private readonly List<IDisposable> _connections = [];

    public RelayedCommands(bool reconnect = false, bool answersDataCommands = true)
    {
        Reader = new NeuronReader(_server.Options(reconnect: reconnect));
        Broadcaster = Broadcasts.Started(new BroadcasterOptions { Reader = Reader, Port = 0, AnswerDataCommands = answersDataCommands });
    }

    public NeuronReader Reader { get; }

    public Broadcaster Broadcaster { get; }

    public BroadcasterStatistics Statistics => Broadcaster.GetStatistics();

    /// <summary>Connects a client and waits until the broadcaster serves it.</summary>
    public async Task<TestClient> ConnectAsync()
    {
        int before = Statistics.Clients;
        TestClient client = await TestClient.ConnectAsync(Broadcaster.LocalEndPoint, allowsCutEnd: true);
        _connections.Add(client);
        await Limits.UntilAsync(() => Statistics.Clients == before + 1);
        return client;
    }

    /// <summary>Starts the reader and waits until the server accepts it.</summary>
    public Task<TestConnection> StartAsync()
    {
        Reader.Start();
        return AcceptAsync();
    }

    /// <summary>Waits until the server accepts the reader, also again after a lost connection.</summary>
    public async Task<TestConnection> AcceptAsync()
    {
        TestConnection source = await _server.AcceptAsync();
        _connections.Add(source);
        await Limits.UntilAsync(() => Reader.Status.IsConnected);
        return source;
    }

    /// <summary>Sends a request of a client and checks that it is the next that the server receives.</summary>
    public static async Task PassAsync(TestClient client, TestConnection source, byte[] request)
    {
        await client.Socket.SendAsync(request);
        Assert.Equal(request, await ReceiveAsync(source, request.Length));
    }

    public static async Task<byte[]> ReceiveAsync(TestConnection source, int length)
    {
        byte[] bytes = new byte[length];
        for (int received = 0; received < length;)
        {
            int count = await source.Socket.ReceiveAsync(bytes.AsMemory(received), TestContext.Current.CancellationToken).Soon();
            Assert.NotEqual(0, count);
            received += count;
        }

        return bytes;
    }

    /// <summary>Disconnects a client. A client that has left is noticed when something is sent to it.</summary>
    public async Task LeaveAsync(TestClient client, TestConnection source)
    {
        int before = Statistics.Clients;
        client.Dispose();
        while (Statistics.Clients >= before)
        {
            await source.SendAsync(TestPackets.Motion(0));
            await Task.Yield();
        }
    }

    public async ValueTask DisposeAsync()
    {
        _connections.ForEach(static connection => connection.Dispose());
        await Broadcaster.DisposeAsync();
        await Reader.DisposeAsync();
        _server.Dispose();
    }
}
