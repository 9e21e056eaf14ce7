using NeuronMocap.Native.Tests.Infrastructure;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Native.Tests.Functions;

// The process has one callback of each kind, which can be registered, replaced and removed at any time.
public sealed class RegisterTests
{
    [Fact]
    public async Task Every_callback_has_its_own_object()
    {
        using var server = new TestServer();
        await using var driver = new Driver();
        (_, TestConnection connection) = await driver.ConnectAsync(server);
        byte[] both = TestPackets.Join(TestPackets.Calculation(1), TestPackets.Motion(1));
        await connection.SendAsync(both);
        await driver.FramesAsync(1);

        await driver.CallAsync("register frame x");
        await driver.CallAsync("register calculation y");
        await driver.CallAsync("register status z");
        await connection.SendAsync(both);
        await driver.FramesAsync(2);
        connection.Close();
        await driver.StatusesAsync(4);

        Assert.Equal(["f", "x"], driver.Frames.Select(static frame => frame.Object));
        Assert.Equal(["c", "y"], driver.Calculations.Select(static frame => frame.Object));
        Assert.Equal(["s", "s", "z", "z"], driver.Statuses.Select(static status => status.Object));
        await driver.EndAsync();
    }

    [Fact]
    public async Task Frames_and_statuses_are_ignored_without_a_callback()
    {
        using var server = new TestServer();
        await using var driver = new Driver();
        await driver.CallAsync("register status");
        (string handle, TestConnection connection) = await driver.ConnectAsync(server);
        await driver.CallAsync("register frame");
        await connection.SendAsync(TestPackets.Join(TestPackets.Motion(1), TestPackets.Calculation(1)));
        await driver.UntilAsync(() => driver.Calculations.Count == 1);
        await driver.CallAsync("register calculation");
        await driver.CallAsync("register frame x");
        await connection.SendAsync(TestPackets.Join(TestPackets.Calculation(2), TestPackets.Motion(2)));
        await driver.FramesAsync(1);
        await driver.CallAsync("close " + handle);

        Assert.Equal(2u, driver.Frames[0].FrameIndex);
        Assert.Single(driver.Calculations);
        Assert.Empty(driver.Statuses);
        connection.Dispose();
        await driver.EndAsync();
    }

    [Fact]
    public async Task Callbacks_may_replace_and_unregister_each_other()
    {
        using var server = new TestServer();
        await using var driver = new Driver();
        (_, TestConnection connection) = await driver.ConnectAsync(server);
        await driver.CallAsync("when frame register frame x");
        await driver.CallAsync("when calculation register frame");
        await driver.CallAsync("when calculation register calculation");
        await driver.CallAsync("when status:Data register status");
        await driver.CallAsync("when status:Failed register status z");

        await connection.SendAsync(TestPackets.Join(
            TestPackets.Motion(1), TestPackets.Motion(2), TestPackets.Calculation(3), TestPackets.Motion(4), TestPackets.Calculation(5)));
        connection.Close();

        // A status is printed before its reaction.
        await driver.UntilAsync(() => driver.Statuses.Count == 4 && driver.Reactions.Count == 5);

        Assert.Equal(["f", "x"], driver.Frames.Select(static frame => frame.Object));
        Assert.Equal(["s", "s", "s", "z"], driver.Statuses.Select(static status => status.Object));
        Assert.Single(driver.Calculations);
        Assert.NotEqual(Driver.None, await driver.ConnectAsync(server.Port));
        Assert.Equal(4, driver.Statuses.Count);
        await driver.EndAsync();
    }

    // The old object may be freed after that: no later call uses it.
    [Fact]
    public async Task A_replaced_callback_is_not_called_again()
    {
        using var server = new TestServer();
        await using var driver = new Driver();
        (_, TestConnection connection) = await driver.ConnectAsync(server);
        for (int i = 0; i < 20; i++)
        {
            string letter = ((char)('a' + i)).ToString();
            await driver.CallAsync("register frame " + letter);
            await connection.SendAsync(TestPackets.Motion(i));
            await driver.FramesAsync(i + 1);
            Assert.Equal(letter, driver.Frames[i].Object);
        }

        connection.Dispose();
        await driver.EndAsync();
    }
}
