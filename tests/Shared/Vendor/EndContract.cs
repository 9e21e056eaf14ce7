using System.Net.Sockets;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Vendor;

// The end of connections: by the server, by the program, and inside callbacks.
public abstract class EndContract
{
    private protected abstract VendorDriver Start();

    // A driver whose close waits until a running callback ends; null where programs cannot choose this.
    private protected virtual VendorDriver? StartPatient() => null;

    [Fact]
    public async Task A_closed_connection_is_reported_on_another_thread_after_the_last_frame()
    {
        using var server = new TestServer();
        await using VendorDriver driver = Start();
        (string handle, TestConnection connection) = await driver.ConnectAsync(server);
        await driver.CallAsync("whenever status get-status sender");

        await connection.SendAsync(TestPackets.Motions(1, 20));
        connection.Close();
        await driver.StatusesAsync(4);

        // A status is printed before its reaction.
        await driver.UntilAsync(() => driver.Reactions.Count == 2);

        Assert.Equal(["0 Failed to read data.", @"0 Data thread exited.\n"], driver.LinesOf(handle).Skip(2));
        Assert.All(driver.Statuses.Skip(2), static status => Assert.NotEqual("main", status.Thread));
        Assert.All(driver.Statuses.Skip(2), static status => Assert.Equal(20, status.FramesBefore));
        Assert.Equal("Failed to read data.", await driver.CallAsync("error"));
        Assert.Equal("2", await driver.CallAsync("get-status " + handle));
        Assert.Equal(["2", "2"], driver.Reactions);
        await driver.EndAsync();
    }

    [Fact]
    public async Task A_reset_sets_the_systems_error_code()
    {
        using var server = new TestServer();
        await using VendorDriver driver = Start();
        (string handle, TestConnection connection) = await driver.ConnectAsync(server);

        connection.Reset();
        await driver.StatusesAsync(4);

        Assert.Equal(["0 Failed to read data.", @"0 Data thread exited.\n"], driver.LinesOf(handle).Skip(2));
        Assert.Equal($"Failed to read data. System error code: {VendorError.CodeOf(SocketError.ConnectionReset)}", await driver.CallAsync("error"));
        await driver.EndAsync();
    }

    // The vendor's library returns the dead handle again until it is closed.
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public async Task After_the_end_connecting_again_makes_a_new_connection(bool closesFirst)
    {
        using var server = new TestServer();
        await using VendorDriver driver = Start();
        (string dead, TestConnection connection) = await driver.ConnectAsync(server);
        connection.Close();
        await driver.StatusesAsync(4);
        if (closesFirst)
        {
            await driver.CallAsync("close " + dead);
            Assert.Equal(new DriverStatus("s", dead, "main", @"2 Service is stoped\n", 0), driver.Statuses[4]);
        }

        (string handle, connection) = await driver.ConnectAsync(server);
        Assert.NotEqual(dead, handle);
        Assert.Equal("2", await driver.CallAsync("get-status " + dead));

        // If a program closes the dead handle late, that does not affect the new connection.
        await driver.CallAsync("close " + dead);
        await connection.SendAsync(TestPackets.Motion(2));
        await driver.FramesAsync(1);
        Assert.Equal(handle, driver.Frames[0].Sender);
        connection.Dispose();
        await driver.EndAsync();
    }

    [Fact]
    public async Task Closing_is_reported_once_on_the_calling_thread()
    {
        using var server = new TestServer();
        await using VendorDriver driver = Start();
        (string handle, TestConnection connection) = await driver.ConnectAsync(server);
        await driver.CallAsync("whenever status get-status sender");

        await driver.CallAsync("close " + handle);
        await driver.CallAsync("close " + handle);
        await driver.CallAsync("close " + VendorDriver.None);

        Assert.Equal(new DriverStatus("s", handle, "main", @"2 Service is stoped\n", 0), Assert.Single(driver.Statuses.Skip(2)));
        Assert.Equal(["2"], driver.Reactions);
        Assert.Equal("2", await driver.CallAsync("get-status " + handle));
        await Limits.UntilAsync(() => connection.Socket.HasEnded());
        await driver.EndAsync();
        Assert.Equal(3, driver.Statuses.Count);
    }

    // Closing usually waits only briefly for a callback that runs. On a busy computer, such a callback may print its frame after that, in some rounds.
    [Fact]
    public async Task No_callback_begins_after_closing()
    {
        int quiet = 0;
        using var server = new TestServer();
        VendorDriver? patient = StartPatient();
        await using VendorDriver driver = patient ?? Start();
        for (int i = 0; i < 5; i++)
        {
            (string handle, TestConnection connection) = await driver.ConnectAsync(server);
            int before = driver.Frames.Count;
            Task sending = SendUntilClosedAsync(connection);
            await driver.FramesAsync(before + 1);

            await driver.CallAsync("close " + handle);
            int count = driver.Frames.Count;

            // When this ends, the sender has seen its end.
            await sending.Soon();
            await driver.CallAsync("error");
            int late = driver.Frames.Count - count;
            Assert.InRange(late, 0, patient is null ? 1 : 0);
            quiet += late == 0 ? 1 : 0;
            connection.Dispose();
        }

        Assert.InRange(quiet, 1, 5);
        await driver.EndAsync();
    }

    [Fact]
    public async Task Closing_in_the_frame_callback_makes_that_frame_the_last()
    {
        using var server = new TestServer();
        await using VendorDriver driver = Start();
        await driver.CallAsync("whenever frame close sender");
        (string handle, TestConnection connection) = await driver.ConnectAsync(server);

        await connection.SendAsync(TestPackets.Motions(0, 50));
        await driver.UntilAsync(() => driver.Reactions.Count == 1);

        Assert.Equal(@"2 Service is stoped\n", driver.Statuses[2].Line);
        Assert.Equal(driver.Frames[0].Thread, driver.Statuses[2].Thread);
        Assert.NotEqual("main", driver.Statuses[2].Thread);
        await Limits.UntilAsync(() => connection.Socket.HasEnded());
        Assert.NotEqual(handle, await driver.ConnectAsync(server.Port));
        await driver.EndAsync();
        Assert.Single(driver.Frames);
    }

    [Fact]
    public async Task Closing_and_reconnecting_in_the_status_callback_works()
    {
        using var server = new TestServer();
        await using VendorDriver driver = Start();
        (string first, TestConnection connection) = await driver.ConnectAsync(server);
        await driver.CallAsync("when status:Failed close sender");
        await driver.CallAsync($"when status:Service connect 127.0.0.1 {server.Port}");

        connection.Close();
        await driver.UntilAsync(() => driver.Reactions.Count == 2);

        string second = driver.Reactions[0];
        Assert.Equal("closed", driver.Reactions[1]);
        Assert.Equal(["0 Failed to read data.", @"2 Service is stoped\n"], driver.LinesOf(first).Skip(2));
        Assert.Equal(2, driver.LinesOf(second).Count());
        Assert.Equal("0", await driver.CallAsync("get-status " + second));
        using TestConnection again = await server.AcceptAsync();
        await again.SendAsync(TestPackets.Motion(1));
        await driver.FramesAsync(1);
        Assert.Equal(second, driver.Frames[0].Sender);
        await driver.EndAsync();
    }

    [Fact]
    public async Task Connecting_in_the_frame_callback_works()
    {
        using var server = new TestServer();
        using var other = new TestServer();
        await using VendorDriver driver = Start();
        (_, TestConnection connection) = await driver.ConnectAsync(server);
        await driver.CallAsync($"when frame connect 127.0.0.1 {other.Port}");

        await connection.SendAsync(TestPackets.Motion(1));
        using TestConnection second = await other.AcceptAsync();
        await second.SendAsync(TestPackets.Motion(2));
        await driver.UntilAsync(() => driver.Frames.Count == 2 && driver.Reactions.Count == 1);

        Assert.Equal(driver.Reactions[0], driver.Frames[1].Sender);
        Assert.Equal(driver.Frames[0].Thread, driver.Statuses[^1].Thread);
        connection.Dispose();
        await driver.EndAsync();
    }

    [Fact]
    public async Task A_busy_callback_does_not_block_closing_for_long()
    {
        using var server = new TestServer();
        await using VendorDriver driver = Start();
        (string handle, TestConnection connection) = await driver.ConnectAsync(server);
        await driver.CallAsync("when frame hold");
        await connection.SendAsync(TestPackets.Motions(1, 2));
        await driver.UntilAsync(() => driver.Reactions.Count == 1);

        await driver.CallAsync("close " + handle);
        await driver.CallAsync("release");
        await driver.UntilAsync(() => driver.Reactions.Count == 2);

        // The memory passed to a callback stays valid until the end of the call.
        (_, connection) = await driver.ConnectAsync(server);
        await connection.SendAsync(TestPackets.Motion(3));
        await driver.FramesAsync(2);
        Assert.Equal([1u, 3u], driver.Frames.Select(static frame => frame.FrameIndex));
        await driver.EndAsync();
    }

    // In bursts, so that some frames are in transit, and no faster than the driver can print them.
    private static async Task SendUntilClosedAsync(TestConnection connection)
    {
        byte[] burst = TestPackets.Motions(0, 20);
        try
        {
            while (true)
            {
                await connection.SendAsync(burst);
                await Task.Delay(5, TestContext.Current.CancellationToken);
            }
        }
        catch (System.Net.Sockets.SocketException)
        {
            // Closed by the other side, as expected.
        }
    }
}
