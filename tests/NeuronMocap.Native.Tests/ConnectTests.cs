using NeuronMocap.Native.Tests.Infrastructure;

namespace NeuronMocap.Native.Tests;

public sealed class ConnectTests
{
    [Fact]
    public async Task A_refused_connection_is_told_and_the_program_ends()
    {
        await using NativeProgram program = NativeProgram.Start("driver");
        Assert.Equal("No error.", await program.CallAsync("error"));
        Assert.Equal("(nil)", await program.CallAsync("connect 127.0.0.1 1"));
        Assert.Equal("Failed to connect to '127.0.0.1:1'. System error code: 111", await program.CallAsync("error"));
        Assert.Equal(0, await program.EndAsync());
        Assert.Empty(program.Errors);
    }
}
