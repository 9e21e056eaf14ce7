using NeuronMocap.Native.Tests.Infrastructure;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Native.Tests.Functions;

public sealed class LastErrorTests
{
    [Fact]
    public async Task The_last_error_stays_in_the_same_memory()
    {
        using var server = new TestServer();
        await using var driver = new Driver();
        string address = await driver.CallAsync("error-address");
        Assert.Equal("No error.", await driver.CallAsync("error"));

        await driver.ConnectAsync(0, "empty");
        (_, TestConnection connection) = await driver.ConnectAsync(server);
        Assert.Equal("Failed to connect to ':0'. System error code: 22", await driver.CallAsync("error"));

        // Also from another thread.
        await driver.CallAsync("when frame error");
        await driver.CallAsync("when calculation error-address");
        await connection.SendAsync(TestPackets.Join(TestPackets.Motion(1), TestPackets.Calculation(2)));
        await driver.UntilAsync(() => driver.Reactions.Count == 2);
        Assert.Equal(["Failed to connect to ':0'. System error code: 22", address], driver.Reactions);
        Assert.Equal(address, await driver.CallAsync("error-address"));
        connection.Dispose();
        await driver.EndAsync();
    }

    [Fact]
    public async Task A_long_error_is_cut_to_its_memory()
    {
        await using var driver = new Driver();
        Assert.Equal(Driver.None, await driver.ConnectAsync(7001, "long"));
        Assert.Equal("1023", await driver.CallAsync("error-length"));
        Assert.StartsWith("Failed to connect to 'xxx", await driver.CallAsync("error"), StringComparison.Ordinal);
        await driver.EndAsync();
    }
}
