using System.Net.Sockets;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Vendor;

// In its own class, so that other tests run meanwhile: it takes the library 5 s.
public abstract class UnansweredContract
{
    private protected abstract VendorDriver Start();

    [Fact]
    public async Task A_silent_server_times_out()
    {
        using var hole = new BlackHole();
        await using VendorDriver driver = Start();
        Assert.Equal(VendorDriver.None, await driver.ConnectAsync(hole.Port));
        Assert.Equal($"Failed to connect to '127.0.0.1:{hole.Port}'. System error code: {VendorError.CodeOf(SocketError.TimedOut)}", await driver.CallAsync("error"));
        Assert.Equal(3, driver.Statuses.Count);
        await driver.EndAsync();
    }
}
