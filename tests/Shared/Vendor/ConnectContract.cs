using System.Net.Sockets;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Vendor;

// The start of connections (protocol.md section 10), with exact texts.
public abstract class ConnectContract
{
    private protected abstract VendorDriver Start();

    [Fact]
    public async Task A_connection_is_reported_on_the_connecting_thread_with_its_handle()
    {
        using var server = new TestServer();
        await using VendorDriver driver = Start();
        await driver.CallAsync("whenever status get-status sender");

        string handle = await driver.ConnectAsync(server.Port);

        Assert.NotEqual(VendorDriver.None, handle);
        Assert.Equal(
            [
                new DriverStatus("s", handle, "main", $@"1 Connecting to 127.0.0.1:{server.Port} ...\n", 0),
                new DriverStatus("s", handle, "main", $"0 Successfully connected to '127.0.0.1:{server.Port}'.", 0),
            ],
            driver.Statuses);
        Assert.Equal(["1", "0"], driver.Reactions);
        Assert.Equal("0", await driver.CallAsync("get-status " + handle));
        await driver.EndAsync();
    }

    [Fact]
    public async Task A_refused_connection_is_reported_and_null()
    {
        int port;
        using (var server = new TestServer())
            port = server.Port;

        await using VendorDriver driver = Start();
        await driver.CallAsync("whenever status get-status sender");
        await driver.CallAsync("when status:Failed error");

        Assert.Equal(VendorDriver.None, await driver.ConnectAsync(port));

        string handle = driver.Statuses[0].Sender;
        Assert.NotEqual(VendorDriver.None, handle);
        Assert.Equal(
            [
                new DriverStatus("s", handle, "main", $@"1 Connecting to 127.0.0.1:{port} ...\n", 0),
                new DriverStatus("s", handle, "main", $"1 Failed to connect to '127.0.0.1:{port}'.", 0),
                new DriverStatus("s", handle, "main", @"2 Service is stoped\n", 0),
            ],
            driver.Statuses);
        string error = $"Failed to connect to '127.0.0.1:{port}'. System error code: {VendorError.CodeOf(SocketError.ConnectionRefused)}";
        Assert.Equal(["1", "1", error, "2"], driver.Reactions);
        Assert.Equal(error, await driver.CallAsync("error"));
        Assert.Equal("2", await driver.CallAsync("get-status " + handle));
        await driver.EndAsync();
    }

    // The vendor's library ends the process if it cannot find a name.
    [Theory]
    [InlineData("no-such-computer.invalid", 7001, "no-such-computer.invalid:7001", 11001)]
    [InlineData("陈.invalid", 7001, "陈.invalid:7001", 11001)]
    [InlineData("empty", 7001, ":7001", null)]
    [InlineData("null", 7001, ":7001", null)]
    [InlineData("127.0.0.1", 0, "127.0.0.1:0", null)]
    [InlineData("127.0.0.1", 65_536, "127.0.0.1:65536", null)]
    [InlineData("127.0.0.1", -1, "127.0.0.1:-1", null)]
    public async Task An_impossible_host_fails_without_a_crash(string host, int port, string told, int? code)
    {
        string error = $"Failed to connect to '{told}'. System error code: {code ?? VendorError.CodeOf(SocketError.InvalidArgument)}";
        await using VendorDriver driver = Start();
        Assert.Equal(VendorDriver.None, await driver.ConnectAsync(port, host));
        Assert.Equal(error, await driver.CallAsync("error"));
        Assert.Equal(3, driver.Statuses.Count);
        Assert.Equal(VendorDriver.None, await driver.CallAsync(FormattableString.Invariant($"connect-commands {host} {port}")));
        Assert.Equal(error, await driver.CallAsync("error"));
        Assert.Equal(3, driver.Statuses.Count);
        await driver.EndAsync();
    }

    [Fact]
    public async Task A_name_is_looked_up()
    {
        using var server = new TestServer();
        await using VendorDriver driver = Start();
        string handle = await driver.ConnectAsync(server.Port, "localhost");
        Assert.Equal($"0 Successfully connected to 'localhost:{server.Port}'.", driver.LinesOf(handle).Last());
        await driver.EndAsync();
    }

    [Fact]
    public async Task A_second_call_for_the_same_address_gives_the_same_connection()
    {
        using var server = new TestServer();
        await using VendorDriver driver = Start();
        (string handle, TestConnection connection) = await driver.ConnectAsync(server);

        Assert.Equal(handle, await driver.ConnectAsync(server.Port));

        Assert.Equal(2, driver.Statuses.Count);
        await connection.SendAsync(TestPackets.Motion(1));
        await driver.FramesAsync(1);
        Assert.NotEqual(handle, await driver.ConnectAsync(server.Port, "localhost"));
        connection.Dispose();
        await driver.EndAsync();
    }

    [Fact]
    public async Task Handles_are_never_reused()
    {
        using var server = new TestServer();
        await using VendorDriver driver = Start();
        var seen = new HashSet<string>(StringComparer.Ordinal) { VendorDriver.None };
        for (int i = 0; i < 20; i++)
        {
            string handle = await driver.ConnectAsync(server.Port);
            Assert.True(seen.Add(handle));
            await driver.CallAsync("close " + handle);
            Assert.Equal("2", await driver.CallAsync("get-status " + handle));
        }

        await driver.EndAsync();
    }

    // The server sends as soon as it accepts. The status callback is slow, so the frame waits.
    [Fact]
    public async Task No_frame_precedes_the_connected_status()
    {
        using var server = new TestServer();
        await using VendorDriver driver = Start();
        await driver.CallAsync("whenever status:Successfully connect 127.0.0.1 1");
        for (int i = 1; i <= 10; i++)
        {
            Task<TestConnection> accepting = SendAtOnceAsync(server);
            string handle = await driver.ConnectAsync(server.Port);
            using TestConnection connection = await accepting;
            await driver.FramesAsync(i);
            Assert.All(driver.Statuses.Where(status => status.Sender == handle), status => Assert.Equal(i - 1, status.FramesBefore));
            await driver.CallAsync("close " + handle);
        }

        await driver.EndAsync();
    }

    [Theory]
    [InlineData("Connecting")]
    [InlineData("Successfully")]
    public async Task Closing_in_the_connected_callback_gives_null(string text)
    {
        using var server = new TestServer();
        await using VendorDriver driver = Start();
        await driver.CallAsync($"when status:{text} close sender");

        Assert.Equal(VendorDriver.None, await driver.ConnectAsync(server.Port));

        Assert.Equal(["closed"], driver.Reactions);
        Assert.Equal(@"2 Service is stoped\n", driver.Statuses[^1].Line);
        Assert.DoesNotContain(driver.Statuses, static status => status.Line.Contains("Failed", StringComparison.Ordinal));
        Assert.NotEqual(VendorDriver.None, await driver.ConnectAsync(server.Port));
        await driver.EndAsync();
    }

    [Fact]
    public async Task Connecting_elsewhere_in_the_connected_callback_works()
    {
        using var server = new TestServer();
        using var other = new TestServer();
        await using VendorDriver driver = Start();
        await driver.CallAsync($"when status:Connecting connect 127.0.0.1 {other.Port}");

        string handle = await driver.ConnectAsync(server.Port);

        string inner = Assert.Single(driver.Reactions);
        Assert.NotEqual(handle, inner);
        Assert.Equal("0", await driver.CallAsync("get-status " + handle));
        Assert.Equal("0", await driver.CallAsync("get-status " + inner));
        await driver.EndAsync();
    }

    [Fact]
    public async Task Connecting_again_in_the_connected_callback_gives_the_same_connection()
    {
        using var server = new TestServer();
        await using VendorDriver driver = Start();
        await driver.CallAsync($"whenever status connect 127.0.0.1 {server.Port}");

        string handle = await driver.ConnectAsync(server.Port);

        Assert.Equal([handle, handle], driver.Reactions);
        Assert.Equal(2, driver.Statuses.Count);
        await driver.EndAsync();
    }

    [Fact]
    public async Task Closing_from_another_thread_ends_connecting()
    {
        using var hole = new BlackHole();
        await using VendorDriver driver = Start();
        await driver.CallAsync($"thread connect 127.0.0.1 {hole.Port}");
        await driver.StatusesAsync(1);
        string handle = driver.Statuses[0].Sender;
        Assert.Equal("1", await driver.CallAsync("get-status " + handle));

        await driver.CallAsync("close " + handle);
        await driver.UntilAsync(() => driver.Reactions.Count == 1);

        Assert.Equal([VendorDriver.None], driver.Reactions);
        Assert.Equal("main", driver.Statuses.Last(status => status.Sender == handle).Thread);
        Assert.Equal([$@"1 Connecting to 127.0.0.1:{hole.Port} ...\n", @"2 Service is stoped\n"], driver.LinesOf(handle));
        await driver.EndAsync();
    }

    private static async Task<TestConnection> SendAtOnceAsync(TestServer server)
    {
        TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        return connection;
    }
}
