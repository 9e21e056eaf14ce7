using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server.Osc;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Server.Tests.Osc;

public sealed class DatagramTargetTests : IDisposable
{
    private static readonly byte[] Bytes = [1, 2, 3, 4];

    private readonly Socket _receiver = new(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
    private readonly List<string> _lookUps = [];
    private long _now = 1000 * Stopwatch.Frequency;

    public DatagramTargetTests() => _receiver.Bind(new IPEndPoint(IPAddress.Loopback, 0));

    private int Port => ((IPEndPoint)_receiver.LocalEndPoint!).Port;

    public void Dispose() => _receiver.Dispose();

    [Fact]
    public void An_address_is_used_at_once()
    {
        using DatagramTarget target = Create("127.0.0.1", static _ => throw new InvalidOperationException());
        Assert.True(target.Prepare());
        Assert.True(target.TrySend(Bytes, 3));
        Assert.Equal([1, 2, 3], Receive());
        Assert.Equal((1, 3, 0, null), (target.Datagrams, target.Bytes, target.Failed, target.Failure));
    }

    [Fact]
    public void A_name_is_looked_up_again_after_longer_and_longer_pauses()
    {
        using DatagramTarget target = Create("studio", static _ => throw new SocketException((int)SocketError.HostNotFound));
        List<int> seconds = [];
        for (int second = 0; second < 120; second++)
        {
            int before = _lookUps.Count;
            Assert.False(target.Prepare());
            if (_lookUps.Count > before)
                seconds.Add(second);
            Assert.False(target.TrySend(Bytes, 4));
            _now += Stopwatch.Frequency;
        }

        Assert.Equal([0, 1, 3, 7, 15, 31, 61, 91], seconds);
        Assert.Equal("the host name studio has no address (HostNotFound)", target.Failure);
        Assert.Equal(120, target.Failed);
    }

    [Fact]
    public void Nothing_waits_for_a_name_and_its_address_is_used_when_it_comes()
    {
        var answer = new TaskCompletionSource<IPAddress[]>();
        using DatagramTarget target = Create("studio", _ => answer.Task);
        Assert.False(target.Prepare());
        _now += 100 * Stopwatch.Frequency;
        Assert.False(target.Prepare());
        answer.SetResult([IPAddress.IPv6Loopback, IPAddress.Loopback]);
        Assert.True(target.Prepare());
        Assert.True(target.TrySend(Bytes, 4));
        Assert.Equal(Bytes, Receive());
        Assert.Equal(["studio"], _lookUps);
    }

    [Fact]
    public void A_name_without_an_address_is_a_failure()
    {
        using DatagramTarget target = Create("studio", static _ => Task.FromResult<IPAddress[]>([]));
        Assert.False(target.Prepare());
        Assert.Equal("the host name studio has no address (no address)", target.Failure);
    }

    [Fact]
    public async Task A_port_without_a_receiver_is_counted_and_gets_datagrams_as_soon_as_there_is_one()
    {
        Assert.SkipWhen(OperatingSystem.IsMacOS(), "macOS does not report refusals on loopback reliably.");
        int port = FreePort.Next();
        using var target = new DatagramTarget("127.0.0.1", port, static _ => throw new InvalidOperationException(), () => _now);
        Assert.True(target.Prepare());
        await Limits.UntilAsync(() => target.TrySend(Bytes, 4) && target.Refused > 0);
        Assert.Equal((0, null), (target.Failed, target.Failure));

        using var late = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        late.Bind(new IPEndPoint(IPAddress.Loopback, port));
        await Limits.UntilAsync(() => target.TrySend(Bytes, 4) && late.Available > 0);
    }

    [Fact]
    public async Task A_name_that_refuses_is_looked_up_again_and_may_be_another_computer()
    {
        Assert.SkipWhen(OperatingSystem.IsMacOS(), "macOS does not report refusals on loopback reliably.");
        Loopback.NeedManyAddresses();
        IPAddress[] addresses = [IPAddress.Parse("127.0.0.9"), IPAddress.Loopback];
        int next = 0;
        using DatagramTarget target = Create("studio", _ => Task.FromResult<IPAddress[]>([addresses[Math.Min(next++, 1)]]));
        Assert.True(target.Prepare());
        await Limits.UntilAsync(() => target.TrySend(Bytes, 4) && target.Refused > 0);
        _now += Stopwatch.Frequency;
        Assert.True(target.Prepare());
        Assert.True(target.TrySend(Bytes, 4));
        Assert.Equal(Bytes, Receive());
        Assert.Equal(2, next);
    }

    [Fact]
    public void A_failed_network_opens_a_new_socket_later()
    {
        // A link-local address without its network card cannot be reached.
        IPAddress[] addresses = [IPAddress.Parse("fe80::1"), IPAddress.Loopback];
        int next = 0;
        using DatagramTarget target = Create("studio", _ => Task.FromResult<IPAddress[]>([addresses[Math.Min(next++, 1)]]));
        Assert.SkipWhen(target.Prepare() && target.TrySend(Bytes, 4), "This computer has a route to every address.");
        Assert.StartsWith($"nothing can be sent to studio:{Port} (", target.Failure, StringComparison.Ordinal);
        _now += Stopwatch.Frequency;
        Assert.True(target.Prepare());
        Assert.Null(target.Failure);
        Assert.True(target.TrySend(Bytes, 4));
        Assert.Equal(Bytes, Receive());
    }

    // A computer without IPv6, or a process without free handles.
    [Theory]
    [InlineData("127.0.0.1")]
    [InlineData("studio")]
    public void A_socket_that_the_system_refuses_is_a_failure_until_it_grants_one(string host)
    {
        bool isRefusing = true;
        using var target = new DatagramTarget(host, Port, static _ => Task.FromResult<IPAddress[]>([IPAddress.Loopback]), () => _now, family =>
            isRefusing ? throw new SocketException((int)SocketError.TooManyOpenSockets) : new Socket(family, SocketType.Dgram, ProtocolType.Udp));
        Assert.False(target.Prepare());
        Assert.Equal($"nothing can be sent to {host}:{Port} (TooManyOpenSockets)", target.Failure);
        isRefusing = false;
        _now += Stopwatch.Frequency;
        Assert.True(target.Prepare());
        Assert.Null(target.Failure);
        Assert.True(target.TrySend(Bytes, 4));
        Assert.Equal(Bytes, Receive());
    }

    [Fact]
    public void An_address_is_tried_once_a_second()
    {
        int attempts = 0;
        using var target = new DatagramTarget("127.0.0.1", Port, static _ => throw new InvalidOperationException(), () => _now, _ =>
        {
            attempts++;
            throw new SocketException((int)SocketError.NetworkDown);
        });
        for (int half = 0; half < 120; half++)
        {
            Assert.False(target.Prepare());
            _now += Stopwatch.Frequency / 2;
        }

        Assert.Equal(60, attempts);
    }

    private DatagramTarget Create(string host, Func<string, Task<IPAddress[]>> resolve) => new(host, Port, name => LookUp(name, resolve), () => _now);

    private Task<IPAddress[]> LookUp(string name, Func<string, Task<IPAddress[]>> resolve)
    {
        _lookUps.Add(name);
        return resolve(name);
    }

    private byte[] Receive()
    {
        byte[] buffer = new byte[100];
        _receiver.ReceiveTimeout = (int)Limits.Unexpected.TotalMilliseconds;
        return buffer[.._receiver.Receive(buffer)];
    }
}
