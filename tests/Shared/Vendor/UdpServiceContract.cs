using System.Net;
using System.Net.Sockets;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Vendor;

public abstract class UdpServiceContract
{
    private protected abstract VendorDriver Start();

    [Fact]
    public async Task A_service_receives_and_calls_no_status_callback()
    {
        await using VendorDriver driver = Start();
        int port = FreePort.Next();
        string service = await driver.CallAsync($"udp {port}");
        Assert.Equal("0", await driver.CallAsync("get-status " + service));

        Send(port, TestPackets.Motion(1), TestPackets.Calculation(2));
        await driver.UntilAsync(() => driver.Frames.Count == 1 && driver.Calculations.Count == 1);
        await driver.CallAsync("close " + service);
        await driver.CallAsync("close " + service);

        Assert.Equal((service, "f"), (driver.Frames[0].Sender, driver.Frames[0].Object));
        Assert.Equal((service, "c"), (driver.Calculations[0].Sender, driver.Calculations[0].Object));
        Assert.NotEqual("main", driver.Frames[0].Thread);
        Assert.Equal("2", await driver.CallAsync("get-status " + service));
        Assert.Empty(driver.Statuses);
        await driver.EndAsync();
    }

    // The vendor's library lost the frames of a macOS server, which come in two datagrams.
    [Fact]
    public async Task A_frame_in_two_datagrams_is_joined()
    {
        await using VendorDriver driver = Start();
        int port = FreePort.Next();
        await driver.CallAsync($"udp {port}");
        byte[] packet = TestPackets.Motion(1);
        Send(port, packet[..1024], packet[1024..]);
        await driver.FramesAsync(1);
        Assert.Equal(packet[..64], driver.Frames[0].Header);
        Assert.Equal(DriverFrame.HashOf(packet.AsSpan(64)), driver.Frames[0].Hash);
        await driver.EndAsync();
    }

    // The system decides which of the two receives a datagram.
    [Fact]
    public async Task Every_call_starts_its_own_service()
    {
        await using VendorDriver driver = Start();
        int port = FreePort.Next();
        string first = await driver.CallAsync($"udp {port}");
        string second = await driver.CallAsync($"udp {port}");
        Assert.NotEqual(VendorDriver.None, second);
        Assert.NotEqual(first, second);

        Send(port, TestPackets.Motion(1));
        await driver.FramesAsync(1);
        await driver.CallAsync("close " + driver.Frames[0].Sender);
        Send(port, TestPackets.Motion(2));
        await driver.FramesAsync(2);

        Assert.Equal(new HashSet<string> { first, second }, driver.Frames.Select(static frame => frame.Sender).ToHashSet(StringComparer.Ordinal));
        await driver.EndAsync();
    }

    [Fact]
    public async Task An_unavailable_port_is_null_with_an_error()
    {
        using var other = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp) { ExclusiveAddressUse = true };
        other.Bind(new IPEndPoint(IPAddress.Any, 0));
        int port = ((IPEndPoint)other.LocalEndPoint!).Port;
        await using VendorDriver driver = Start();

        Assert.Equal(VendorDriver.None, await driver.CallAsync($"udp {port}"));
        Assert.Equal($"Failed to bind UDP service to port {port}. System error code: {VendorError.CodeOf(SocketError.AddressAlreadyInUse)}", await driver.CallAsync("error"));
        Assert.Equal(VendorDriver.None, await driver.CallAsync("udp -1"));
        Assert.Equal($"Failed to bind UDP service to port -1. System error code: {VendorError.CodeOf(SocketError.InvalidArgument)}", await driver.CallAsync("error"));
        Assert.Equal(VendorDriver.None, await driver.CallAsync("udp 65536"));
        Assert.Equal($"Failed to bind UDP service to port 65536. System error code: {VendorError.CodeOf(SocketError.InvalidArgument)}", await driver.CallAsync("error"));
        Assert.NotEqual(VendorDriver.None, await driver.CallAsync("udp 0"));
        await driver.EndAsync();
    }

    [Fact]
    public async Task Closing_in_the_frame_callback_makes_that_frame_the_last()
    {
        await using VendorDriver driver = Start();
        int port = FreePort.Next();
        string service = await driver.CallAsync($"udp {port}");
        await driver.CallAsync("when frame close sender");

        Send(port, TestPackets.Motions(1, 10));
        await driver.UntilAsync(() => driver.Reactions.Count == 1);
        string again = await driver.CallAsync($"udp {port}");
        Send(port, TestPackets.Motion(11));
        await driver.FramesAsync(2);

        Assert.NotEqual(service, again);
        Assert.Equal([1u, 11u], driver.Frames.Select(static frame => frame.FrameIndex));
        await driver.EndAsync();
    }

    private static void Send(int port, params byte[][] datagrams)
    {
        using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        foreach (byte[] datagram in datagrams)
            socket.SendTo(datagram, new IPEndPoint(IPAddress.Loopback, port));
    }
}
