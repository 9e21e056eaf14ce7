using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Transport;

// A timer delivers waiting datagrams. It alternates with the receive loop, which the test replaces.
public sealed class UdpPendingTimerTests
{
    private readonly ReceiveGate _gate = new();
    private readonly Receiver _receiver = new();
    private readonly UdpSenders _senders;

    public UdpPendingTimerTests() => _senders = new UdpSenders(new PacketScanner(), _receiver, new SenderFilter([]));

    [Fact]
    public async Task The_timer_delivers_waiting_frames_repeatedly()
    {
        using var settling = new UdpPendingTimer(_senders, _gate);
        for (int port = 5000; port < 5003; port++)
        {
            Push(port);
            await Limits.UntilAsync(() => _receiver.Packets == port - 4999);
        }
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void The_end_delivers_waiting_frames(bool isClosed)
    {
        var settling = new UdpPendingTimer(_senders, _gate);
        PushBoth();
        if (isClosed)
            _gate.Close();

        settling.Dispose();
        settling.Dispose();
        Assert.Equal((2, false), (_receiver.Packets, _senders.IsWaiting));
    }

    [Fact]
    public async Task A_blocked_timer_handler_holds_back_the_receive_loop_and_the_end()
    {
        using var blocked = new ManualResetEventSlim();
        using var release = new ManualResetEventSlim();
        var settling = new UdpPendingTimer(_senders, _gate);
        _receiver.OnSecond = () =>
        {
            blocked.Set();
            release.Wait(Limits.Unexpected);
        };
        PushBoth();
        await Task.Run(() => Assert.True(blocked.Wait(Limits.Unexpected))).Soon();

        Task<bool> receiving = Task.Run(_gate.TryEnter);
        Assert.False(_gate.TryEnterIdle());
        Assert.False(receiving.IsCompleted);
        Task ended = Task.Run(settling.Dispose);
        release.Set();
        Assert.True(await receiving.Soon());
        Assert.True(_gate.TryLeave());
        await ended.Soon();
        Assert.Equal(2, _receiver.Packets);
    }

    [Fact]
    public async Task An_exception_of_the_timer_reaches_the_awaiter_of_the_end()
    {
        using var settling = new UdpPendingTimer(_senders, _gate);
        Task end = _gate.UntilClosedAsync(new TaskCompletionSource<bool>().Task);
        _receiver.OnSecond = static () => throw new InvalidOperationException("a fault");
        PushBoth();

        Assert.Equal("a fault", (await Assert.ThrowsAsync<InvalidOperationException>(() => end.Soon())).Message);
        Assert.False(_gate.TryEnter());
    }

    [Fact]
    public async Task An_exception_of_the_timer_ends_the_link()
    {
        using var link = new UdpLink(
            new NeuronReaderOptions { Transport = TransportKind.Udp, LocalAddress = IPAddress.Loopback, Port = 0 }.Link, new SenderFilter([]));
        Assert.Equal(ConnectionReason.None, (await link.OpenAsync(TestContext.Current.CancellationToken)).Reason);
        _receiver.OnSecond = static () => throw new InvalidOperationException("a fault");
        Task<LinkEnd> end = link.ReceiveAsync(_receiver, listener: null);
        using var first = new UdpClient();
        using var second = new UdpClient();
        first.Send(TestPackets.Motion(1), 1480, (IPEndPoint)link.LocalEndPoint!);
        await Limits.UntilAsync(() => _receiver.Packets == 1);
        second.Send(TestPackets.Motion(2), 1480, (IPEndPoint)link.LocalEndPoint!);

        Assert.Equal("a fault", (await Assert.ThrowsAsync<InvalidOperationException>(() => end.Soon())).Message);
    }

    // The second datagram waits, because it comes from another port of the address.
    private void PushBoth()
    {
        Push(5000);
        Push(5001);
    }

    private void Push(int port)
    {
        Assert.True(_gate.TryEnter());
        _senders.Push(new IPEndPoint(IPAddress.Loopback, port).Serialize(), TestPackets.Motion(port), Stopwatch.GetTimestamp());
        Assert.True(_gate.TryLeave());
    }

    private sealed class Receiver : IPacketReceiver
    {
        private int _packets;

        public Action? OnSecond { get; set; }

        public int Packets => Volatile.Read(ref _packets);

        public void OnPacket(in ReceivedPacket packet)
        {
            if (Interlocked.Increment(ref _packets) == 2)
                OnSecond?.Invoke();
        }

        public void OnText(ReadOnlySpan<byte> bytes, PacketKind kind)
        {
        }

        public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason)
        {
        }
    }
}
