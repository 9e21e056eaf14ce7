using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Native.Tests.Infrastructure;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Native.Tests.Generations;

/// <summary>Programs with the header struct of b12, with servers of every generation.</summary>
public sealed class HeaderLayoutTests
{
    private const string Variable = "NEURONDATAREADER_HEADER";

    // Compiled with the current headers, or earlier and with the environment variable set.
    [Theory]
    [InlineData("b12", null)]
    [InlineData("b12-binary", "b12")]
    public async Task Frames_of_every_generation_and_text_come_with_the_old_header(string name, string? variable)
    {
        using var server = new TestServer();
        await using NativeProgram program = Start(name, variable);
        await program.CallAsync("register");
        string socket = await program.CallAsync($"connect 127.0.0.1 {server.Port}");
        using TestConnection connection = await server.AcceptAsync();

        await connection.SendAsync(TestPackets.Join(
            TestPackets.Motion(1, avatar: 0),
            TestPackets.Motion(1, avatar: 1, count: 186, name: "陈-0123456789-0123456789-01234"),
            TestPackets.Motion(2, avatar: 0, count: 180, layout: HeaderLayout.Old),
            TestPackets.Motion(2, avatar: 1, count: 360, name: "Second", layout: HeaderLayout.Old),
            B12Frame.OldPacket(3, compressed: 1, reserved: 0x01020304)));

        Assert.Equal(B12Frame.LineOf(socket, 1), await program.ReadAsync("frame"));
        Assert.Equal(B12Frame.LineOf(socket, 1, avatar: 1, count: 186, name: "陈-0123456789-0123456789-01234"), await program.ReadAsync());
        Assert.Equal(B12Frame.LineOf(socket, 2, count: 180), await program.ReadAsync());
        Assert.Equal(B12Frame.LineOf(socket, 2, avatar: 1, count: 360, name: "Second"), await program.ReadAsync());
        Assert.Equal(B12Frame.LineOf(socket, 3, version: "1.0.3.4", compressed: 1, reserved: 0x01020304), await program.ReadAsync());
        Assert.Equal("No error.", await program.CallAsync("error"));
        await AssertTextAsync(program, server);
        Assert.Equal(0, await program.EndAsync());
        Assert.Empty(program.Errors);
    }

    // Axis Studio's reserved fields hold a timecode, not a compression flag.
    [Fact]
    public async Task A_timecode_is_not_taken_for_compression()
    {
        byte[] packet = TestPackets.Motion(7);
        packet[2] = 1;
        packet.AsSpan(50, 12).Fill(0x11);
        using var server = new TestServer();
        await using NativeProgram program = Start("b12");
        await program.CallAsync("register");
        string socket = await program.CallAsync($"connect 127.0.0.1 {server.Port}");
        using TestConnection connection = await server.AcceptAsync();

        await connection.SendAsync(packet);

        Assert.Equal(B12Frame.LineOf(socket, 7), await program.ReadAsync("frame"));
    }

    [Fact]
    public async Task Datagrams_come_with_the_old_header_too()
    {
        int port = FreePort.Next();
        await using NativeProgram program = Start("b12");
        await program.CallAsync("register");
        string service = await program.CallAsync($"udp {port}");
        using var sender = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        byte[] packet = TestPackets.Motion(5);

        // The way Axis Neuron on macOS sends a frame.
        sender.SendTo(packet.AsSpan(0, 1024), new IPEndPoint(IPAddress.Loopback, port));
        sender.SendTo(packet.AsSpan(1024), new IPEndPoint(IPAddress.Loopback, port));

        Assert.Equal(B12Frame.LineOf(service, 5), await program.ReadAsync("frame"));
    }

    [Fact]
    public async Task A_new_layout_applies_from_the_next_frame_and_an_unknown_one_is_ignored()
    {
        using var server = new TestServer();
        await using NativeProgram program = Start("b12-binary");
        await program.CallAsync("register");
        string socket = await program.CallAsync($"connect 127.0.0.1 {server.Port}");
        using TestConnection connection = await server.AcceptAsync();

        byte[] sent = TestPackets.Motion(1);
        await connection.SendAsync(sent);
        Assert.Equal("new frame " + Convert.ToHexString(sent.AsSpan(0, 64)), await program.ReadAsync("new frame"));

        await program.CallAsync("layout 1");
        await connection.SendAsync(sent);
        Assert.Equal(B12Frame.LineOf(socket, 1), await program.ReadAsync());

        await program.CallAsync("layout 2");
        Assert.Equal("Header layout 2 does not exist.", await program.CallAsync("error"));
        await program.CallAsync("layout -1");
        Assert.Equal("Header layout -1 does not exist.", await program.CallAsync("error"));
        await connection.SendAsync(TestPackets.Motion(2, layout: HeaderLayout.Old));
        Assert.Equal(B12Frame.LineOf(socket, 2), await program.ReadAsync());

        await program.CallAsync("layout 0");
        await connection.SendAsync(sent);
        Assert.Equal("new frame " + Convert.ToHexString(sent.AsSpan(0, 64)), await program.ReadAsync());
    }

    // Programs may set it themselves, up to that call.
    [Fact]
    public async Task The_variable_is_read_at_the_first_call()
    {
        using var server = new TestServer();
        await using NativeProgram program = Start("b12-binary");
        await program.CallAsync("setenv b12");
        await program.CallAsync("register");
        await program.CallAsync("setenv b18");
        string socket = await program.CallAsync($"connect 127.0.0.1 {server.Port}");
        using TestConnection connection = await server.AcceptAsync();

        await connection.SendAsync(TestPackets.Motion(1));

        Assert.Equal(B12Frame.LineOf(socket, 1), await program.ReadAsync("frame"));
    }

    [Theory]
    [InlineData("B12", "NEURONDATAREADER_HEADER is 'B12'; it must be 'b12' or not set.")]
    [InlineData("", "No error.")]
    public async Task An_unknown_value_selects_the_new_header_with_a_warning(string value, string error)
    {
        using var server = new TestServer();
        await using NativeProgram program = Start("b12-binary", value);
        await program.CallAsync("register");
        await program.CallAsync($"connect 127.0.0.1 {server.Port}");
        using TestConnection connection = await server.AcceptAsync();

        await connection.SendAsync(TestPackets.Motion(1));

        await program.ReadAsync("new frame");
        Assert.Equal(error, await program.CallAsync("error"));
    }

    // Values are exact in text.
    private static async Task AssertTextAsync(NativeProgram program, TestServer server)
    {
        string socket = await program.CallAsync($"connect localhost {server.Port}");
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Join(TestPackets.Line(4), TestPackets.Line(5, avatar: 1, count: 180)));

        Assert.Equal(B12Frame.LineOf(socket, 4), await program.ReadAsync("frame"));
        Assert.Equal(B12Frame.LineOf(socket, 5, avatar: 1, count: 180), await program.ReadAsync());
    }

    private static NativeProgram Start(string name, string? variable = null)
    {
        ProcessStartInfo start = NativeProgram.Prepare(name);
        start.Environment.Remove(Variable);
        if (variable is not null)
            start.Environment[Variable] = variable;

        return NativeProgram.Start(start);
    }
}
