using System.Diagnostics;
using NeuronMocap.Protocol;
using NeuronMocap.Reader;
using NeuronMocap.Skeleton;
using NeuronMocap.Telemetry;
using NeuronMocap.Tests.Network;
using NeuronMocap.Tests.Reader;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Transport;

// Links that end at once, on the test's own thread, simulate a day of bad network in a moment. Alone, because it measures the memory of the process.
[Collection(nameof(Alone))]
public sealed class ConnectionSupervisorTests
{
    private static readonly byte[] Frame = TestPackets.Motion(1);

    private readonly CancellationTokenSource _stop = new();
    private readonly List<ConnectionStatus> _told = [];
    private readonly StatusPublisher _status;
    private readonly LinkActivity _activity;
    private readonly ReceivePipeline _pipeline;
    private bool _isLogged = true;
    private int _toldCount;

    public ConnectionSupervisorTests()
    {
        _status = new StatusPublisher(Tell);
        _activity = new LinkActivity(_status, TimeSpan.FromSeconds(3), udpSenders: null);
        _pipeline = new ReceivePipeline(SkeletonFormat.Default, new StreamRecognizer(SkeletonFormat.Default), _activity, _status, [new SenderFilter([])], new ReaderMetrics("supervisor"), _ => false, new ReaderRecordings(new NeuronReaderOptions(), "supervisor"), _ => { });
    }

    [Fact]
    public async Task A_hundred_thousand_connections_leave_nothing_behind()
    {
        const int Links = 100_000;
        const int Warm = 1_000;
        _isLogged = false;
        int made = 0;
        int closed = 0;
        long heap = 0;
        long allocated = 0;
        ConnectionStatus end = await SuperviseAsync(new ReconnectPolicy { InitialDelay = TimeSpan.FromTicks(1), MaxDelay = TimeSpan.FromTicks(1) }, () =>
        {
            if (made == Warm)
            {
                heap = ProcessResources.LiveHeap();
                allocated = GC.GetAllocatedBytesForCurrentThread();
            }

            bool isLast = ++made == Links;
            return new FakeLink(
                receiver =>
                {
                    receiver.OnPacket(new ReceivedPacket(PacketKind.Motion, Frame, Stopwatch.GetTimestamp(), 0));
                    if (isLast)
                        _stop.Cancel();

                    return new LinkEnd(isLast ? ConnectionReason.Requested : ConnectionReason.Reset, "cut");
                },
                () => closed++);
        });
        allocated = GC.GetAllocatedBytesForCurrentThread() - allocated;
        heap = ProcessResources.LiveHeap() - heap;

        Assert.Equal((ConnectionState.Stopped, ConnectionReason.Requested), (end.State, end.Reason));
        Assert.Equal((Links, Links), (made, closed - 1)); // the stop closes the last one
        Assert.Equal((Links, Links - 1L), (_pipeline.GetStatistics().MotionFrames, _pipeline.GetStatistics().Reconnects));

        // Connecting, Connected, Receiving and Waiting. The last link does not wait.
        Assert.Equal((4 * Links) - 1, _toldCount);
        Assert.InRange(allocated / (Links - Warm), 0, 4096);
        Assert.InRange(heap, long.MinValue, 1_000_000);
    }

    [Fact]
    public async Task A_link_that_ended_before_the_stop_keeps_its_reason()
    {
        ConnectionStatus end = await SuperviseAsync(new ReconnectPolicy { Enabled = false }, () => new FakeLink(_ =>
        {
            _stop.Cancel();
            return new LinkEnd(ConnectionReason.ClosedByPeer, "closed");
        }));
        Assert.Equal((ConnectionState.Stopped, ConnectionReason.ClosedByPeer, "closed"), (end.State, end.Reason, end.Message));
    }

    [Fact]
    public async Task A_link_with_a_pending_retry_is_ended_by_the_stop()
    {
        ConnectionStatus end = await SuperviseAsync(new ReconnectPolicy(), () => new FakeLink(_ =>
        {
            _stop.Cancel();
            return new LinkEnd(ConnectionReason.ClosedByPeer, "closed");
        }));
        Assert.Equal((ConnectionState.Stopped, ConnectionReason.Requested), (end.State, end.Reason));
    }

    [Fact]
    public async Task Delays_follow_the_policy_and_reset_after_frames()
    {
        int made = 0;
        await SuperviseAsync(new ReconnectPolicy { InitialDelay = TimeSpan.FromMilliseconds(1), MaxDelay = TimeSpan.FromMilliseconds(4) }, () => new FakeLink(receiver =>
        {
            if (++made == 5)
                receiver.OnPacket(new ReceivedPacket(PacketKind.Motion, Frame, Stopwatch.GetTimestamp(), 0));
            if (made == 8)
                _stop.Cancel();

            return new LinkEnd(ConnectionReason.Reset, "cut");
        }));
        Assert.Equal(
            [(1, 1.0), (2, 2.0), (3, 4.0), (4, 4.0), (0, 1.0), (1, 1.0), (2, 2.0)],
            _told.Where(status => status.State == ConnectionState.Waiting).Select(status => (status.Attempt, status.RetryIn!.Value.TotalMilliseconds)));
    }

    [Fact]
    public async Task A_failure_before_the_link_is_reported_and_retried()
    {
        int made = 0;
        ConnectionStatus end = await SuperviseAsync(new ReconnectPolicy { InitialDelay = TimeSpan.FromMilliseconds(1) }, () => ++made == 1
            ? throw new InvalidOperationException("Object reference not set.")
            : new FakeLink(_ =>
            {
                _stop.Cancel();
                return LinkEnd.Requested;
            }));

        Assert.Equal((2, ConnectionReason.Requested), (made, end.Reason));
        ConnectionStatus waiting = Assert.Single(_told, status => status.State == ConnectionState.Waiting);
        Assert.Equal(ConnectionReason.NetworkError, waiting.Reason);
        Assert.Equal("Receiving from the server failed because of an error in this library (System.InvalidOperationException). Please report it.", waiting.Message);
    }

    private Task<ConnectionStatus> SuperviseAsync(ReconnectPolicy policy, Func<Link> createLink) =>
        new ConnectionSupervisor(createLink, policy, _status, _activity, () => 0).RunAsync(_pipeline, _pipeline, _stop.Token).Soon();

    private void Tell(ConnectionStatus status)
    {
        _toldCount++;
        if (_isLogged)
            _told.Add(status);
    }

    private sealed class FakeLink(Func<IPacketReceiver, LinkEnd> receive, Action? closed = null) : Link
    {
        public override string Target => "fake";

        public override ReceiveThread ReceiveThread => ReceiveThread.Dedicated;

        public override Task<LinkEnd> OpenAsync(CancellationToken cancellationToken) => Task.FromResult(LinkEnd.None);

        public override Task<LinkEnd> ReceiveAsync(IPacketReceiver receiver, ILinkListener? listener) => Task.FromResult(receive(receiver));

        public override void Close() => closed?.Invoke();
    }
}
