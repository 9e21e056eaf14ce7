using System.Diagnostics;
using System.Net.Sockets;
using NeuronDataReaderWraper;
using NeuronMocap.Compatibility.Tests.Infrastructure;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Compatibility.Tests.Sockets;

// How connections end: by the server, by the program, and from inside every callback.
public sealed class EndTests
{
    private static readonly TimeSpan Bound = Limits.Unexpected / 2;

    [Fact]
    public async Task A_server_that_closes_is_told_and_the_status_is_the_truth()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        await server.SendAsync(TestPackets.Motion(1));
        await log.FramesAsync(1);
        SocketStatus? asked = null;
        log.OnStatus = status => asked ??= NeuronDataReader.BRGetSocketStatus(status.Socket);

        // Waits without letting go of its thread, which therefore cannot be the one that tells.
        server.Connection.Close();
        Assert.True(SpinWait.SpinUntil(() => log.Statuses.Count == 4, Limits.Unexpected));

        Assert.Equal(["0 Failed to read data.", "0 Data thread exited.\n"], log.LinesOf(server.Socket).Skip(2));
        Assert.All(log.Statuses.Skip(2), static status => Assert.NotEqual(Environment.CurrentManagedThreadId, status.Thread));
        Assert.Equal(SocketStatus.CS_OffWork, asked);
        Assert.Equal(SocketStatus.CS_OffWork, NeuronDataReader.BRGetSocketStatus(server.Socket));
        Assert.Equal("Failed to read data.", NeuronDataReader.strBRGetLastErrorMessage());
    }

    [Fact]
    public async Task A_server_that_resets_leaves_the_systems_number()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);

        server.Connection.Reset();
        await Limits.UntilAsync(() => log.Statuses.Count == 4);

        Assert.Equal(["0 Failed to read data.", "0 Data thread exited.\n"], log.LinesOf(server.Socket).Skip(2));
        int code = new SocketException((int)SocketError.ConnectionReset).ErrorCode;
        Assert.Equal($"Failed to read data. System error code: {code}", NeuronDataReader.strBRGetLastErrorMessage());
    }

    // The vendor's library gives the dead handle again until it is closed.
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public async Task After_the_end_connecting_again_makes_a_new_connection(bool closesFirst)
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        IntPtr dead = server.Socket;
        server.Connection.Close();
        await Limits.UntilAsync(() => log.Statuses.Count == 4);
        if (closesFirst)
        {
            NeuronDataReader.BRCloseSocket(dead);
            Assert.Equal("2 Service is stoped\n", log.LinesOf(dead).Last());
        }

        await server.ReconnectAsync(log);

        Assert.NotEqual(dead, server.Socket);
        Assert.Equal(SocketStatus.CS_OffWork, NeuronDataReader.BRGetSocketStatus(dead));
        await server.SendAsync(TestPackets.Motion(1));
        await log.FramesAsync(1);
        Assert.Equal(server.Socket, Assert.Single(log.Frames).Socket);

        // The dead handle of a program that closes late closes nothing of the new connection.
        NeuronDataReader.BRCloseSocket(dead);
        await server.SendAsync(TestPackets.Motion(2));
        await log.FramesAsync(2);
    }

    [Fact]
    public async Task Closing_is_told_once_by_the_caller_and_may_be_repeated()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);

        NeuronDataReader.BRCloseSocket(server.Socket);
        NeuronDataReader.BRCloseSocket(server.Socket);
        NeuronDataReader.BRCloseSocket(IntPtr.Zero);
        NeuronDataReader.BRCloseSocket(new IntPtr(-1));

        LoggedStatus last = Assert.Single(log.Statuses.Skip(2));
        Assert.Equal(("2 Service is stoped\n", Environment.CurrentManagedThreadId), (last.Line, last.Thread));
        Assert.Equal(SocketStatus.CS_OffWork, NeuronDataReader.BRGetSocketStatus(server.Socket));
        Assert.Equal(SocketStatus.CS_OffWork, NeuronDataReader.BRGetSocketStatus(IntPtr.Zero));
        await Limits.UntilAsync(() => HasEnded(server.Connection.Socket));
    }

    [Fact]
    public async Task No_callback_comes_after_closing()
    {
        byte[] frames = TestPackets.Motions(0, 20);
        using var log = new CallbackLog(isPatient: true);
        using PacketServer server = await PacketServer.ConnectAsync(log);
        for (int i = 0; i < 10; i++)
        {
            TestConnection connection = server.Connection;
            int before = log.Frames.Count;
            Task sending = Task.Run(() => SendUntilClosed(connection.Socket, frames));
            await log.FramesAsync(before + 1);

            NeuronDataReader.BRCloseSocket(server.Socket);
            int count = log.Frames.Count;

            // The sender has seen the end of it when this ends.
            await sending.Soon();
            Assert.Equal(count, log.Frames.Count);
            connection.Dispose();
            await server.ReconnectAsync(log);
        }
    }

    [Fact]
    public async Task Closing_in_the_frame_callback_makes_that_frame_the_last()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        log.OnFrame = static socket =>
        {
            NeuronDataReader.BRCloseSocket(socket);
            NeuronDataReader.BRCloseSocket(socket);
        };

        await server.Connection.SendAsync(TestPackets.Motions(0, 50));
        await Limits.UntilAsync(() => log.Statuses.Count == 3);

        Assert.Equal("2 Service is stoped\n", log.Statuses[2].Line);
        Assert.Single(log.Frames);
        Assert.Empty(log.Failures);
        await server.ReconnectAsync(log);
    }

    [Theory]
    [InlineData("Connecting")]
    [InlineData("Successfully")]
    public void Closing_while_the_connection_is_told_gives_zero(string text)
    {
        using var server = new TestServer();
        using var log = new CallbackLog();
        log.OnStatus = status =>
        {
            if (status.Text.StartsWith(text, StringComparison.Ordinal))
                NeuronDataReader.BRCloseSocket(status.Socket);
        };
        long start = Stopwatch.GetTimestamp();

        Assert.Equal(IntPtr.Zero, log.Connect(server.Port));

        Assert.True(Stopwatch.GetElapsedTime(start) < Bound);
        Assert.Equal("2 Service is stoped\n", log.Statuses[^1].Line);
        Assert.DoesNotContain(log.Statuses, static status => status.Text.StartsWith("Failed", StringComparison.Ordinal));
    }

    [Fact]
    public async Task Closing_and_connecting_again_when_the_end_is_told_works()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        IntPtr again = IntPtr.Zero;
        log.OnStatus = status =>
        {
            if (status.Text == "Failed to read data.")
            {
                NeuronDataReader.BRCloseSocket(status.Socket);
                again = log.Connect(server.Port);
            }
        };
        TestConnection first = server.Connection;

        first.Close();
        await Limits.UntilAsync(() => log.Statuses.Count == 6);

        Assert.Equal(
            ["0 Failed to read data.", "2 Service is stoped\n"],
            log.LinesOf(server.Socket).Skip(2));
        Assert.Equal(2, log.LinesOf(again).Count());
        Assert.Equal(SocketStatus.CS_Running, NeuronDataReader.BRGetSocketStatus(again));
    }

    [Fact]
    public async Task Connecting_to_another_server_in_the_frame_callback_works()
    {
        using var other = new TestServer();
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        IntPtr socket = IntPtr.Zero;
        log.OnFrame = _ => socket = log.Connect(other.Port);

        await server.SendAsync(TestPackets.Motion(1));
        using TestConnection connection = await other.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(2));
        await log.FramesAsync(2);

        Assert.Equal(socket, log.Frames[1].Socket);
    }

    [Fact]
    public async Task A_busy_callback_does_not_hold_up_closing_for_long()
    {
        using var log = new CallbackLog();
        using var release = new ManualResetEventSlim();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        log.OnFrame = _ => release.Wait(Limits.Unexpected);
        await server.SendAsync(TestPackets.Motion(1), TestPackets.Motion(2));
        await log.FramesAsync(1);
        long start = Stopwatch.GetTimestamp();

        NeuronDataReader.BRCloseSocket(server.Socket);

        Assert.True(Stopwatch.GetElapsedTime(start) < Bound);
        release.Set();
        await server.ReconnectAsync(log);
        await server.SendAsync(TestPackets.Motion(3));
        await log.FramesAsync(2);
        Assert.Equal([1u, 3u], log.Frames.Select(static frame => frame.Motion.FrameIndex));
    }

    // In an orderly way or not: that depends on what was under way.
    internal static bool HasEnded(Socket socket)
    {
        try
        {
            return socket.Poll(0, SelectMode.SelectRead) && socket.Receive(new byte[1]) == 0;
        }
        catch (SocketException)
        {
            return true;
        }
    }

    private static void SendUntilClosed(Socket socket, byte[] bytes)
    {
        try
        {
            while (true)
                socket.Send(bytes);
        }
        catch (SocketException)
        {
            // Closed by the other side, as meant.
        }
    }
}
