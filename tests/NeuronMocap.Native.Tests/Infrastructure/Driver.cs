using NeuronMocap.Tests.Vendor;

namespace NeuronMocap.Native.Tests.Infrastructure;

/// <summary>
/// The program driver of tests/native, or another program that understands some of its lines. It offers the vendor's functions as C programs call
/// them.
/// </summary>
internal sealed class Driver(string program = "driver") : VendorDriver
{
    private readonly NativeProgram _program = NativeProgram.Start(program);

    public override async Task EndAsync()
    {
        int code = await _program.EndAsync();
        foreach (string line in _program.ReadRest())
            Keep(line);
        Assert.Empty(_program.Errors);
        Assert.Equal(0, code);
    }

    public override ValueTask DisposeAsync() => _program.DisposeAsync();

    protected override void Write(string line) => _program.Write(line);

    protected override Task<string> ReadAsync() => _program.ReadAsync();
}
