using System.Net;
using System.Net.Sockets;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Transport;

// The behaviour required of every way to wait for a connection's bytes.
public abstract class TcpReceiverTests
{
    internal abstract TcpReceiver Create();

    [Theory]
    [InlineData(1)]
    [InlineData(63)]
    [InlineData(1479)]
    [InlineData(1480)]
    [InlineData(65_536)]
    public async Task Every_packet_arrives_whole_and_in_order(int piece)
    {
        byte[] bytes = TestPackets.Motions(0, piece == 1 ? 3 : 200);
        PacketLog log = await ReceiveAsync(connection => connection.SendPiecesAsync(bytes, piece));
        Same.Items(bytes, log.Packets.SelectMany(static packet => packet.Bytes));
        Assert.Equal(0, log.Skipped);
    }

    [Fact]
    public async Task Bursts_with_silence_between_them_arrive()
    {
        PacketLog? seen = null;
        PacketLog log = await ReceiveAsync(
            async connection =>
            {
                for (int burst = 1; burst <= 20; burst++)
                {
                    await connection.SendAsync(TestPackets.Motions(burst * 100, 100));
                    await Limits.UntilAsync(() => Volatile.Read(ref seen)?.Packets.Count == burst * 100);
                }
            },
            started => Volatile.Write(ref seen, started));
        Assert.Equal(2000, log.Packets.Count);
    }

    [Fact]
    public async Task A_reset_is_thrown()
    {
        SocketException exception = await Assert.ThrowsAsync<SocketException>(() => ReceiveAsync(async connection =>
        {
            await connection.SendAsync(TestPackets.Motion(1));
            connection.Reset();
        }));
        Assert.Equal(SocketError.ConnectionReset, exception.SocketErrorCode);
    }

    [Fact]
    public async Task Closing_the_socket_ends_a_wait_for_bytes()
    {
        using var server = new TestServer();
        using Socket socket = CreateSocket();
        TcpReceiver receiver = Create();
        await receiver.ConnectAsync(socket, new IPEndPoint(IPAddress.Loopback, server.Port)).Soon();
        using TestConnection connection = await server.AcceptAsync();
        var log = new PacketLog();
        Task receiving = receiver.ReceiveAsync(socket, new PacketAssembler(new PacketScanner(), log));
        await connection.SendAsync(TestPackets.Motion(1));
        await Limits.UntilAsync(() => log.Packets.Count == 1);

        socket.Dispose();

        Exception? exception = await Record.ExceptionAsync(() => receiving.Soon());
        Assert.True(exception is SocketException or ObjectDisposedException, exception?.ToString() ?? "completed");
    }

    [Fact]
    public async Task A_refused_connection_is_thrown()
    {
        int port;
        using (var server = new TestServer())
            port = server.Port;

        using Socket socket = CreateSocket();
        SocketException exception = await Assert.ThrowsAsync<SocketException>(
            () => Create().ConnectAsync(socket, new IPEndPoint(IPAddress.Loopback, port)).Soon());
        Assert.Equal(SocketError.ConnectionRefused, exception.SocketErrorCode);
    }

    // Until the other side closes.
    private async Task<PacketLog> ReceiveAsync(Func<TestConnection, Task> send, Action<PacketLog>? started = null)
    {
        using var server = new TestServer();
        using Socket socket = CreateSocket();
        TcpReceiver receiver = Create();
        await receiver.ConnectAsync(socket, new IPEndPoint(IPAddress.Loopback, server.Port)).Soon();
        using TestConnection connection = await server.AcceptAsync();
        var log = new PacketLog();
        Task receiving = receiver.ReceiveAsync(socket, new PacketAssembler(new PacketScanner(), log));
        started?.Invoke(log);
        await send(connection);
        if (connection.Socket.Connected)
            connection.Close();

        await receiving.Soon();
        receiver.Close();
        return log;
    }

    private static Socket CreateSocket() => new(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
}

public sealed class BlockingTcpReceiverTests : TcpReceiverTests
{
    internal override TcpReceiver Create() => new BlockingTcpReceiver();

    [Fact]
    public void The_thread_is_returned_once()
    {
        int released = 0;
        var receiver = new BlockingTcpReceiver(() => released++);
        receiver.Close();
        receiver.Close();
        Assert.Equal(1, released);
    }
}
