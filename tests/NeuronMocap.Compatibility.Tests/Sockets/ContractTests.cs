using NeuronMocap.Compatibility.Tests.Infrastructure;
using NeuronMocap.Tests.Vendor;

namespace NeuronMocap.Compatibility.Tests.Sockets;

// The contract that both surfaces of the vendor's functions keep, applied to the C# class.
public sealed class ConnectContractTests : ConnectContract
{
    private protected override VendorDriver Start() => new ManagedDriver();
}

public sealed class CommandChannelContractTests : CommandChannelContract
{
    private protected override VendorDriver Start() => new ManagedDriver();

    private protected override VendorDriver StartWithCallbacks() => new ManagedDriver();
}

public sealed class EndContractTests : EndContract
{
    private protected override VendorDriver Start() => new ManagedDriver();

    private protected override VendorDriver StartPatient() => new ManagedDriver(isPatient: true);
}

public sealed class UdpServiceContractTests : UdpServiceContract
{
    private protected override VendorDriver Start() => new ManagedDriver();
}

public sealed class UnansweredContractTests : UnansweredContract
{
    private protected override VendorDriver Start() => new ManagedDriver();
}
