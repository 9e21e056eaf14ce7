using NeuronMocap.Native.Tests.Infrastructure;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Native.Tests.Functions;

// In a class of its own, so that others run meanwhile: it takes the library 5 s.
public sealed class UnansweredTests
{
    [Fact]
    public async Task A_server_that_does_not_answer_is_given_up()
    {
        using var hole = new BlackHole();
        await using var driver = new Driver();
        Assert.Equal(Driver.None, await driver.ConnectAsync(hole.Port));
        Assert.Equal($"Failed to connect to '127.0.0.1:{hole.Port}'. System error code: 110", await driver.CallAsync("error"));
        Assert.Equal(3, driver.Statuses.Count);
        await driver.EndAsync();
    }
}
