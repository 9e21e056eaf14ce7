using System.Net;
using System.Net.Sockets;
using NeuronDataReaderWraper;
using NeuronMocap.Compatibility.Tests.Infrastructure;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Compatibility.Tests.Sockets;

public sealed class UdpServiceTests
{
    [Fact]
    public async Task A_service_receives_and_calls_no_status_callback()
    {
        using var log = new CallbackLog();
        int port = FreePort.Udp();
        IntPtr service = log.Listen(port);
        Assert.Equal(SocketStatus.CS_Running, NeuronDataReader.BRGetSocketStatus(service));

        Send(port, TestPackets.Motion(1));
        await log.FramesAsync(1);
        NeuronDataReader.BRCloseSocket(service);
        NeuronDataReader.BRCloseSocket(service);

        Assert.Equal(service, log.Frames[0].Socket);
        Assert.Equal(SocketStatus.CS_OffWork, NeuronDataReader.BRGetSocketStatus(service));
        Assert.Empty(log.Statuses);
    }

    // As in the vendor's library, a second service shares the port; which of the two gets a datagram, the system decides.
    [Fact]
    public async Task Every_call_starts_a_service_of_its_own()
    {
        using var log = new CallbackLog();
        int port = FreePort.Udp();
        IntPtr first = log.Listen(port);
        IntPtr second = log.Listen(port);
        Assert.NotEqual(IntPtr.Zero, second);
        Assert.NotEqual(first, second);

        Send(port, TestPackets.Motion(1));
        await log.FramesAsync(1);
        NeuronDataReader.BRCloseSocket(log.Frames[0].Socket);
        Send(port, TestPackets.Motion(2));
        await log.FramesAsync(2);

        Assert.Equal(new HashSet<IntPtr> { first, second }, log.Frames.Select(static frame => frame.Socket).ToHashSet());
    }

    [Fact]
    public void A_port_that_another_program_keeps_for_itself_is_a_failure()
    {
        using var other = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp) { ExclusiveAddressUse = true };
        other.Bind(new IPEndPoint(IPAddress.Any, 0));
        int port = ((IPEndPoint)other.LocalEndPoint!).Port;
        using var log = new CallbackLog();

        Assert.Equal(IntPtr.Zero, log.Listen(port));

        int code = new SocketException((int)SocketError.AddressAlreadyInUse).ErrorCode;
        Assert.Equal($"Failed to bind UDP service to port {port}. System error code: {code}", NeuronDataReader.strBRGetLastErrorMessage());
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(65_536)]
    public void A_port_that_cannot_be_is_a_failure(int port)
    {
        using var log = new CallbackLog();
        Assert.Equal(IntPtr.Zero, log.Listen(port));
        Assert.StartsWith($"Failed to bind UDP service to port {port}. System error code: ", NeuronDataReader.strBRGetLastErrorMessage(), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Closing_in_the_frame_callback_makes_that_frame_the_last()
    {
        using var log = new CallbackLog();
        int port = FreePort.Udp();
        IntPtr service = log.Listen(port);
        log.OnFrame = static socket => NeuronDataReader.BRCloseSocket(socket);

        Send(port, TestPackets.Motions(1, 10));
        await Limits.UntilAsync(() => NeuronDataReader.BRGetSocketStatus(service) == SocketStatus.CS_OffWork);
        log.OnFrame = null;
        IntPtr again = log.Listen(port);
        Send(port, TestPackets.Motion(11));
        await log.FramesAsync(2);

        Assert.NotEqual(service, again);
        Assert.Equal([1u, 11u], log.Frames.Select(static frame => frame.Motion.FrameIndex));
    }

    private static void Send(int port, byte[] datagram)
    {
        using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        socket.SendTo(datagram, new IPEndPoint(IPAddress.Loopback, port));
    }
}
