using NeuronMocap.Native.Tests.Infrastructure;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Native.Tests.Functions;

// Invalid handles and invalid memory have no effect.
public sealed class HandleTests
{
    private const string NothingDone = "20";

    [Fact]
    public async Task Functions_ignore_null_and_closed_handles()
    {
        using var server = new TestServer();
        using CommandScript commands = CommandScript.Always([1, 0, 0, 0]);
        await using var driver = new Driver();
        string[] handles =
        [
            Driver.None,
            await driver.ConnectAsync(server.Port),
            await driver.CallAsync($"udp {FreePort.Next()}"),
            await driver.CallAsync($"connect-commands 127.0.0.1 {commands.Port}"),
        ];
        foreach (string handle in handles)
        {
            await driver.CallAsync("close " + handle);
            Assert.Equal(NothingDone, await driver.CallAsync("all " + handle));
        }

        Assert.Equal(0, commands.Requests);
        Assert.Equal(3, driver.Statuses.Count);
        await driver.EndAsync();
    }

    // Addresses of the program itself, misaligned addresses, and numbers that no library would return.
    [Fact]
    public async Task Functions_ignore_foreign_handles()
    {
        using var server = new TestServer();
        await using var driver = new Driver();
        (_, TestConnection connection) = await driver.ConnectAsync(server);

        Assert.Equal("0", await driver.CallAsync("all-foreign 10000"));

        await connection.SendAsync(TestPackets.Motion(1));
        await driver.FramesAsync(1);
        Assert.Equal(0, connection.Socket.Available);
        Assert.Equal("No error.", await driver.CallAsync("error"));
        connection.Dispose();
        await driver.EndAsync();
    }

    // A data connection accepts the four commands of b12. A command connection accepts those of b18. A UDP service accepts none.
    [Fact]
    public async Task Functions_ignore_handles_of_other_kinds_of_connection()
    {
        using var server = new TestServer();
        await using var driver = new Driver();
        (string data, TestConnection connection) = await driver.ConnectAsync(server);
        string service = await driver.CallAsync($"udp {FreePort.Next()}");

        Assert.Equal("4", await driver.CallAsync("all " + data));
        Assert.Equal("0", await driver.CallAsync("all " + service));
        connection.Dispose();
        await driver.EndAsync();
    }

    [Fact]
    public async Task A_null_result_fails_the_call_and_sends_nothing()
    {
        using CommandScript commands = CommandScript.Always([1, 0, 0, 0]);
        await using var driver = new Driver();
        string pipe = await driver.CallAsync($"connect-commands 127.0.0.1 {commands.Port}");
        Assert.Equal("0 0 0 0 0 before", await driver.CallAsync("nulls " + pipe));
        Assert.Equal(0, commands.Requests);
        await driver.EndAsync();
    }
}
