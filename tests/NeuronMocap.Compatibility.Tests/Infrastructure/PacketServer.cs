using NeuronMocap.Tests.Network;

namespace NeuronMocap.Compatibility.Tests.Infrastructure;

/// <summary>A server that a test controls, and the connection of a log to it.</summary>
internal sealed class PacketServer : IDisposable
{
    private readonly TestServer _server;

    private PacketServer(TestServer server, TestConnection connection, IntPtr socket)
    {
        _server = server;
        Connection = connection;
        Socket = socket;
    }

    public TestConnection Connection { get; private set; }

    public IntPtr Socket { get; private set; }

    public int Port => _server.Port;

    public static async Task<PacketServer> ConnectAsync(CallbackLog log)
    {
        var server = new TestServer();
        IntPtr socket = log.Connect(server.Port);
        Assert.NotEqual(IntPtr.Zero, socket);
        return new PacketServer(server, await server.AcceptAsync(), socket);
    }

    public async Task ReconnectAsync(CallbackLog log)
    {
        Socket = log.Connect(Port);
        Assert.NotEqual(IntPtr.Zero, Socket);
        Connection = await _server.AcceptAsync();
    }

    public Task SendAsync(params byte[][] packets) => Connection.SendAsync(TestPackets.Join(packets));

    public void Dispose()
    {
        Connection.Dispose();
        _server.Dispose();
    }
}
