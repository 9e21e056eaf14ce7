using NeuronMocap.Native.Tests.Infrastructure;
using NeuronMocap.Tests.Vendor;

namespace NeuronMocap.Native.Tests.Functions;

// The contract that both surfaces of the vendor's functions keep, applied to the C functions.
public sealed class ConnectTests : ConnectContract
{
    private protected override VendorDriver Start() => new Driver();

    // C# texts cannot be invalid in this way.
    [Fact]
    public async Task A_host_name_of_invalid_text_fails_without_a_crash()
    {
        await using VendorDriver driver = Start();
        Assert.Equal(VendorDriver.None, await driver.ConnectAsync(7001, "broken"));
        Assert.Equal("Failed to connect to '\uFFFD\uFFFD.\uFFFD:7001'. System error code: 11001", await driver.CallAsync("error"));
        await driver.EndAsync();
    }
}

public sealed class EndTests : EndContract
{
    private protected override VendorDriver Start() => new Driver();
}

public sealed class UdpServiceTests : UdpServiceContract
{
    private protected override VendorDriver Start() => new Driver();
}

public sealed class UnansweredTests : UnansweredContract
{
    private protected override VendorDriver Start() => new Driver();
}
