using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Transport;

public sealed class TcpLinkTests
{
    [Fact]
    public async Task A_name_without_an_address_is_reported()
    {
        LinkEnd end = await OpenAsync(_ => Task.FromException<IPAddress[]>(new SocketException((int)SocketError.HostNotFound)));
        Assert.Equal(ConnectionReason.HostNotFound, end.Reason);
        Assert.Contains("suit-pc", end.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_name_that_resolves_to_nothing_is_reported() =>
        Assert.Equal(ConnectionReason.HostNotFound, (await OpenAsync(_ => Task.FromResult<IPAddress[]>([]))).Reason);

    [Fact]
    public async Task A_resolver_that_never_answers_is_given_up()
    {
        LinkEnd end = await OpenAsync(_ => new TaskCompletionSource<IPAddress[]>().Task);
        Assert.Equal(ConnectionReason.TimedOut, end.Reason);
        Assert.Contains("could not be resolved", end.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_resolver_failure_is_reported()
    {
        using var link = new TcpLink(new LinkOptions(new string('x', 300), 7001));
        Assert.Equal(ConnectionReason.HostNotFound, (await link.OpenAsync(CancellationToken.None).Soon()).Reason);
    }

    [Theory]
    [InlineData("::1", "127.0.0.1")]
    [InlineData("127.0.0.1", "::1")]
    public async Task A_local_address_of_another_family_is_reported(string host, string local)
    {
        using var link = new TcpLink(new LinkOptions(host, 7001) { LocalAddress = IPAddress.Parse(local) });
        LinkEnd end = await link.OpenAsync(CancellationToken.None).Soon();
        Assert.Equal(ConnectionReason.AddressUnavailable, end.Reason);
        Assert.Contains("of another kind (IPv4, IPv6)", end.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_most_specific_failure_of_several_addresses_is_reported()
    {
        using var server = new TestServer();
        int port = server.Port;
        server.Dispose();
        var options = new LinkOptions("suit-pc", port)
        {
            // The second address is not in this machine's loopback network, so the socket cannot even be bound to reach it.
            Resolve = _ => Task.FromResult<IPAddress[]>([IPAddress.Loopback, IPAddress.Parse("::ffff:0:0")]),
        };
        using var link = new TcpLink(options);
        Assert.Equal(ConnectionReason.Refused, (await link.OpenAsync(CancellationToken.None).Soon()).Reason);
    }

    [Fact]
    public async Task Addresses_are_tried_one_after_the_other()
    {
        using var server = new TestServer();
        var options = new LinkOptions("suit-pc", server.Port) { Resolve = _ => Task.FromResult<IPAddress[]>([IPAddress.Parse("127.0.0.2"), IPAddress.Loopback]) };
        using var link = new TcpLink(options);
        LinkEnd end = await link.OpenAsync(CancellationToken.None).Soon();
        Assert.Equal(ConnectionReason.None, end.Reason);
        Assert.Equal(server.Port, ((IPEndPoint)link.RemoteEndPoint!).Port);
    }

    [Fact]
    public async Task A_foreign_local_address_is_named()
    {
        var options = new LinkOptions("127.0.0.1", 7001) { LocalAddress = IPAddress.Parse("192.0.2.1") };
        using var link = new TcpLink(options);
        LinkEnd end = await link.OpenAsync(CancellationToken.None).Soon();
        Assert.Equal(ConnectionReason.AddressUnavailable, end.Reason);
        Assert.Contains("192.0.2.1", end.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_silent_server_times_out()
    {
        // A listener with a full connection queue drops further attempts, like a black hole.
        using var blackHole = new BlackHole();
        var options = new LinkOptions("127.0.0.1", blackHole.Port) { ConnectTimeout = TimeSpan.FromMilliseconds(200) };
        using var link = new TcpLink(options);
        LinkEnd end = await link.OpenAsync(CancellationToken.None).Soon();
        Assert.Equal(ConnectionReason.TimedOut, end.Reason);
        Assert.Contains("0.2 s", end.Message, StringComparison.Ordinal);
    }

    // On Linux, a socket's send time-out, which command sockets have, also applies to connecting.
    [Fact]
    public async Task Only_its_own_timeout_limits_connecting()
    {
        using var blackHole = new BlackHole();
        var timeout = TimeSpan.FromSeconds(1.5);
        using var link = new TcpLink(new LinkOptions("127.0.0.1", blackHole.Port) { ConnectTimeout = timeout });
        long start = Stopwatch.GetTimestamp();
        LinkEnd end = await link.OpenAsync(CancellationToken.None).Soon();
        Assert.Equal(ConnectionReason.TimedOut, end.Reason);
        Assert.True(Stopwatch.GetElapsedTime(start) > timeout - TimeSpan.FromSeconds(0.1));
    }

    private static async Task<LinkEnd> OpenAsync(Func<string, Task<IPAddress[]>> resolve)
    {
        using var link = new TcpLink(new LinkOptions("suit-pc", 7001) { Resolve = resolve, ConnectTimeout = TimeSpan.FromMilliseconds(200) });
        return await link.OpenAsync(CancellationToken.None).Soon();
    }
}
