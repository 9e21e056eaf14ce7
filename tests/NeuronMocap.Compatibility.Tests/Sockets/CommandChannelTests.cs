using System.Runtime.InteropServices;
using System.Text;
using NeuronDataReaderWraper;
using NeuronMocap.Compatibility.Tests.Infrastructure;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Compatibility.Tests.Sockets;

public sealed class CommandChannelTests
{
    private const string Bvh = "HIERARCHY\nROOT Hips\n{\n OFFSET 0 0 0\n CHANNELS 6 Xposition Yposition Zposition Yrotation Xrotation Zrotation\n"
        + " End Site\n {\n  OFFSET 0 1 0\n }\n}\n";

    [Fact]
    public void Every_command_is_answered()
    {
        using CommandScript server = Answers();
        IntPtr pipe = NeuronDataReader.BRConnectCmd("127.0.0.1", server.Port);
        Assert.NotEqual(IntPtr.Zero, pipe);
        Assert.Equal(SocketStatus.CS_Running, NeuronDataReader.BRGetSocketStatus(pipe));

        Assert.True(NeuronDataReader.ZeroOut(pipe, 1));
        Assert.False(NeuronDataReader.ZeroOut(pipe, 7));
        Assert.False(NeuronDataReader.ZeroOut(pipe, -1));
        Assert.True(NeuronDataReader.ZeroOutAll(pipe));
        Assert.True(NeuronDataReader.GetBvhRotation(pipe, out RotateOrders order));
        Assert.Equal(RotateOrders.RO_ZXY, order);
        Assert.True(NeuronDataReader.GetBoneSize(pipe, 0, out BoneDimension sizes));
        Assert.Equal((0.1f, 0.2f, 1.2f), (sizes.Head, sizes.Neck, sizes.FootLength));

        NeuronDataReader.BRCloseSocket(pipe);
        Assert.False(NeuronDataReader.ZeroOutAll(pipe));
        Assert.Equal(SocketStatus.CS_OffWork, NeuronDataReader.BRGetSocketStatus(pipe));
    }

    [Fact]
    public void The_header_comes_in_every_kind_of_memory_and_never_more_of_it_than_there_is_room()
    {
        using CommandScript server = Answers();
        IntPtr pipe = NeuronDataReader.BRConnectCmd("127.0.0.1", server.Port);

        var text = new StringBuilder("before");
        Assert.True(NeuronDataReader.GetBvhHeader(pipe, 0, text, 100_000));
        Assert.Equal(Bvh, text.ToString());
        Assert.True(NeuronDataReader.GetBvhHeader(pipe, 0, text, 9));
        Assert.Equal("HIERARCHY", text.ToString());

        byte[] bytes = [.. Enumerable.Repeat((byte)'x', Bvh.Length + 2)];
        Assert.True(NeuronDataReader.GetBvhHeader(pipe, 0, bytes, bytes.Length));
        Assert.Equal(Bvh + "\0x", Encoding.UTF8.GetString(bytes));
        bytes.AsSpan().Fill((byte)'x');
        Assert.True(NeuronDataReader.GetBvhHeader(pipe, 0, bytes, 4));
        Assert.StartsWith("HIERx", Encoding.UTF8.GetString(bytes), StringComparison.Ordinal);

        IntPtr memory = Marshal.AllocHGlobal(1000);
        Assert.True(NeuronDataReader.GetBvhHeader(pipe, 0, memory, 1000));
        Assert.Equal(Bvh, Marshal.PtrToStringAnsi(memory));
        Marshal.FreeHGlobal(memory);

        Assert.False(NeuronDataReader.GetBvhHeader(pipe, 0, IntPtr.Zero, 1000));
        Assert.False(NeuronDataReader.GetBvhHeader(pipe, 0, bytes, 0));
        Assert.False(NeuronDataReader.GetBvhHeader(pipe, 0, text, -1));
        NeuronDataReader.BRCloseSocket(pipe);
    }

    [Fact]
    public async Task Other_handles_take_no_commands()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        foreach (IntPtr handle in (IntPtr[])[server.Socket, IntPtr.Zero, new IntPtr(-1)])
        {
            Assert.False(NeuronDataReader.ZeroOut(handle, 0));
            Assert.False(NeuronDataReader.ZeroOutAll(handle));
            Assert.False(NeuronDataReader.GetBvhRotation(handle, out RotateOrders order));
            Assert.Equal(RotateOrders.RO_Unknown, order);
            Assert.False(NeuronDataReader.GetBoneSize(handle, 0, out BoneDimension sizes));
            Assert.Equal(default, sizes);
            Assert.False(NeuronDataReader.GetBvhHeader(handle, 0, new StringBuilder(), 100));
        }

        Assert.Equal(0, server.Connection.Socket.Available);
    }

    [Fact]
    public void A_failed_connection_is_zero_with_an_error_and_no_status_callback()
    {
        int port;
        using (var server = new TestServer())
            port = server.Port;
        using var log = new CallbackLog();

        Assert.Equal(IntPtr.Zero, NeuronDataReader.BRConnectCmd("127.0.0.1", port));
        int code = new System.Net.Sockets.SocketException((int)System.Net.Sockets.SocketError.ConnectionRefused).ErrorCode;
        Assert.Equal($"Failed to connect to '127.0.0.1:{port}'. System error code: {code}", NeuronDataReader.strBRGetLastErrorMessage());
        Assert.Equal(IntPtr.Zero, NeuronDataReader.BRConnectCmd("no-such-computer.invalid", port));
        Assert.EndsWith(" 11001", NeuronDataReader.strBRGetLastErrorMessage(), StringComparison.Ordinal);
        Assert.Equal(IntPtr.Zero, NeuronDataReader.BRConnectCmd("", 0));
        Assert.Empty(log.Statuses);
    }

    // The vendor's library closes the connection after a time-out and gives its dead handle again.
    [Fact]
    public void A_time_out_is_false_and_the_connection_can_be_used_again()
    {
        using CommandScript server = CommandScript.InTurn(static _ => Task.CompletedTask, static request => request.ReplyAsync([1, 0, 0, 0]));
        IntPtr pipe = NeuronDataReader.BRConnectCmd("127.0.0.1", server.Port);
        string error = NeuronDataReader.strBRGetLastErrorMessage();

        Assert.False(NeuronDataReader.ZeroOutAll(pipe));

        Assert.Equal(error, NeuronDataReader.strBRGetLastErrorMessage());
        Assert.Equal(SocketStatus.CS_Running, NeuronDataReader.BRGetSocketStatus(pipe));
        Assert.Equal(pipe, NeuronDataReader.BRConnectCmd("127.0.0.1", server.Port));
        Assert.True(NeuronDataReader.ZeroOutAll(pipe));
        NeuronDataReader.BRCloseSocket(pipe);
    }

    [Fact]
    public void After_the_server_has_gone_the_status_says_so_and_another_handle_is_made()
    {
        int port;
        IntPtr pipe;
        using (CommandScript server = Answers())
        {
            port = server.Port;
            pipe = NeuronDataReader.BRConnectCmd("127.0.0.1", port);
            Assert.True(NeuronDataReader.ZeroOutAll(pipe));
        }

        Assert.False(NeuronDataReader.ZeroOutAll(pipe));
        Assert.Equal(SocketStatus.CS_OffWork, NeuronDataReader.BRGetSocketStatus(pipe));
        Assert.Equal(IntPtr.Zero, NeuronDataReader.BRConnectCmd("127.0.0.1", port));
        NeuronDataReader.BRCloseSocket(pipe);
    }

    // The vendor's library goes on saying that it runs.
    [Fact]
    public async Task A_server_that_closes_an_idle_connection_is_seen_without_asking_it()
    {
        TestConnection? connection = null;
        using var server = new CommandScript(
            static request => request.ReplyAsync([1, 0, 0, 0]),
            accepted =>
            {
                connection = accepted;
                return Task.CompletedTask;
            });
        IntPtr pipe = NeuronDataReader.BRConnectCmd("127.0.0.1", server.Port);
        await Limits.UntilAsync(() => connection is not null);
        Assert.Equal(SocketStatus.CS_Running, NeuronDataReader.BRGetSocketStatus(pipe));

        connection!.Close();
        await Limits.UntilAsync(() => NeuronDataReader.BRGetSocketStatus(pipe) == SocketStatus.CS_OffWork);

        IntPtr again = NeuronDataReader.BRConnectCmd("127.0.0.1", server.Port);
        Assert.NotEqual(pipe, again);
        Assert.True(NeuronDataReader.ZeroOutAll(again));
        Assert.Equal(SocketStatus.CS_Running, NeuronDataReader.BRGetSocketStatus(again));
        Assert.False(NeuronDataReader.ZeroOutAll(pipe));
        NeuronDataReader.BRCloseSocket(again);
    }

    [Fact]
    public void A_text_that_may_not_grow_takes_as_much_as_it_can()
    {
        using CommandScript server = Answers();
        IntPtr pipe = NeuronDataReader.BRConnectCmd("127.0.0.1", server.Port);
        var text = new StringBuilder(4, 9);

        Assert.True(NeuronDataReader.GetBvhHeader(pipe, 0, text, 100_000));

        Assert.Equal("HIERARCHY", text.ToString());
        NeuronDataReader.BRCloseSocket(pipe);
    }

    [Fact]
    public async Task Commands_can_be_asked_in_a_frame_callback()
    {
        using CommandScript answers = Answers();
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        IntPtr pipe = NeuronDataReader.BRConnectCmd("127.0.0.1", answers.Port);
        bool? told = null;
        RotateOrders order = RotateOrders.RO_Unknown;
        log.OnFrame = _ => told = NeuronDataReader.GetBvhRotation(pipe, out order);

        await server.SendAsync(TestPackets.Motion(1));
        await Limits.UntilAsync(() => told is not null);

        Assert.Equal((true, RotateOrders.RO_ZXY), (told, order));
        NeuronDataReader.BRCloseSocket(pipe);
    }

    private static CommandScript Answers() => new(static request => request.Id switch
    {
        1001 => request.ReplyAsync([request.Avatar == 1 ? (byte)1 : (byte)0, 0, 0, 0]),
        1002 => request.ReplyAsync([1, 0, 0, 0]),
        1003 => request.ReplyAsync([4, 0, 0, 0]),
        1004 => request.ReplyAsync([.. Enumerable.Range(1, 12).SelectMany(static i => BitConverter.GetBytes(i / 10f))]),
        _ => request.ReplyAsync(Encoding.ASCII.GetBytes(Bvh)),
    });
}
