using NeuronMocap.Native.Tests.Infrastructure;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Vendor;

namespace NeuronMocap.Native.Tests.Commands;

/// <summary>The command channel from C and C++.</summary>
public sealed class CommandChannelTests : CommandChannelContract
{
    private protected override VendorDriver Start() => new Driver("channel");

    private protected override VendorDriver StartWithCallbacks() => new Driver();

    [Fact]
    public async Task Every_command_is_answered_in_a_Cpp_program()
    {
        await using var driver = new Driver("channel-cpp");
        await AskForEverythingAsync(driver);
    }

    // Programs with older headers, and languages that use an int for a bool and read four bytes.
    [Fact]
    public async Task Other_declarations_of_the_functions_work()
    {
        using CommandScript server = Answers();
        await using NativeProgram program = NativeProgram.Start("channel");
        string pipe = await program.CallAsync($"connect-commands 127.0.0.1 {server.Port}");

        Assert.Equal(await program.CallAsync($"bone-size {pipe} 1"), await program.CallAsync($"bone-size-by-heading {pipe} 1"));
        Assert.Equal("1", await program.CallAsync($"zero-out-as-int {pipe} 0"));
        Assert.Equal("0", await program.CallAsync($"zero-out-as-int {pipe} 7"));
        await program.CallAsync($"close {pipe}");
        Assert.Equal("0", await program.CallAsync($"zero-out-as-int {pipe} 0"));
    }

    [Fact]
    public async Task Four_threads_share_a_handle_and_get_their_own_answers()
    {
        using CommandScript server = Answers();
        await using NativeProgram program = NativeProgram.Start("channel");
        string pipe = await program.CallAsync($"connect-commands 127.0.0.1 {server.Port}");

        Assert.Equal("25 25 25 25", await program.CallAsync($"threads {pipe}"));
        Assert.Equal(4 * 4 * 25, server.Requests);
    }

    [Fact]
    public async Task Closing_ends_a_pending_command()
    {
        var asked = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        using var server = new CommandScript(_ =>
        {
            asked.SetResult();
            return Task.CompletedTask;
        });
        await using NativeProgram program = NativeProgram.Start("channel");
        string pipe = await program.CallAsync($"connect-commands 127.0.0.1 {server.Port}");

        program.Write($"ask-aside {pipe}");
        await asked.Task.Soon();
        program.Write($"close {pipe}");

        string[] lines = [await program.ReadAsync(), await program.ReadAsync()];
        Assert.Equal(["= closed", "asked 0"], lines.Order(StringComparer.Ordinal));
        Assert.Equal(0, await program.EndAsync());
        Assert.Equal(1, server.Requests);
    }
}
