using System.Diagnostics;
using NeuronDataReaderWraper;
using NeuronMocap.Compatibility.Tests.Infrastructure;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Compatibility.Tests.Sockets;

// What a host does when it ends a program and continues itself.
public sealed class SessionTests
{
    private static readonly TimeSpan Bound = Limits.Unexpected;

    [Fact]
    public async Task Ending_closes_all_connections_of_both_namespaces_without_callbacks()
    {
        using var log = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        using var other = new TestServer();
        IntPtr managed = NeuronDataReaderManaged.NeuronDataReader.BRConnectTo("127.0.0.1", other.Port);
        using TestConnection connection = await other.AcceptAsync();
        IntPtr service = log.Listen(FreePort.Next());
        Assert.Equal(SocketStatus.CS_Running, NeuronDataReader.BRGetSocketStatus(service));
        int told = log.Statuses.Count;

        Assert.True(VendorSession.End(Bound));

        Assert.All((IntPtr[])[server.Socket, managed, service], static socket =>
            Assert.Equal(SocketStatus.CS_OffWork, NeuronDataReader.BRGetSocketStatus(socket)));
        await Limits.UntilAsync(() => connection.Socket.HasEnded());
        Assert.Equal(told, log.Statuses.Count);
        Assert.Null(NeuronDataReader.frameDataReceivedCallback);
        Assert.Null(NeuronDataReaderManaged.NeuronDataReader.socketStatusChangedCallback);
        Assert.True(VendorSession.End(TimeSpan.Zero));
    }

    [Fact]
    public async Task After_the_end_a_new_program_can_begin()
    {
        using var first = new CallbackLog();
        using PacketServer server = await PacketServer.ConnectAsync(first);
        IntPtr old = server.Socket;
        VendorSession.End(Bound);

        using var log = new CallbackLog();
        await server.ReconnectAsync(log);
        await server.SendAsync(TestPackets.Motion(1));
        await log.FramesAsync(1);

        Assert.NotEqual(old, server.Socket);
        Assert.Empty(first.Frames);
    }

    [Theory]
    [InlineData(Timeout.Infinite)]
    [InlineData(long.MaxValue / TimeSpan.TicksPerMillisecond)]
    public async Task Ending_waits_without_a_limit_for_a_busy_callback(long milliseconds)
    {
        using var log = new CallbackLog();
        using var release = new ManualResetEventSlim();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        log.OnFrame = _ => release.Wait(Limits.Unexpected);
        await server.SendAsync(TestPackets.Motion(1), TestPackets.Motion(2));
        await log.FramesAsync(1);

        Task<bool> ending = Task.Run(() => VendorSession.End(TimeSpan.FromTicks(milliseconds * TimeSpan.TicksPerMillisecond)));
        await Limits.UntilAsync(() => NeuronDataReader.BRGetSocketStatus(server.Socket) == SocketStatus.CS_OffWork);
        release.Set();

        Assert.True(await ending.Soon());
    }

    [Fact]
    public async Task Ending_waits_for_a_busy_callback_up_to_its_limit()
    {
        // Without the limit, each takes the 2 s allowed for closing a connection.
        var bound = TimeSpan.FromSeconds(1.5);
        TimeSpan quickest = await Limits.QuickestAsync(bound, static () => EndDuringCallbackAsync(TimeSpan.FromMilliseconds(50)));
        Assert.InRange(quickest, TimeSpan.Zero, bound);
    }

    private static async Task<TimeSpan> EndDuringCallbackAsync(TimeSpan timeout)
    {
        using var log = new CallbackLog();
        using var release = new ManualResetEventSlim();
        using PacketServer server = await PacketServer.ConnectAsync(log);
        log.OnFrame = _ => release.Wait(Limits.Unexpected);
        await server.SendAsync(TestPackets.Motion(1), TestPackets.Motion(2));
        await log.FramesAsync(1);
        long start = Stopwatch.GetTimestamp();

        Assert.False(VendorSession.End(timeout));

        TimeSpan elapsed = Stopwatch.GetElapsedTime(start);
        Assert.Equal(SocketStatus.CS_OffWork, NeuronDataReader.BRGetSocketStatus(server.Socket));
        release.Set();
        Assert.Single(log.Frames);
        return elapsed;
    }
}
