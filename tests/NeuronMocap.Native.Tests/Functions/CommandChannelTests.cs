using System.Text;
using NeuronMocap.Native.Tests.Infrastructure;
using NeuronMocap.Tests.Commands;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Native.Tests.Functions;

public sealed class CommandChannelTests
{
    private const string Bvh = "HIERARCHY\nROOT Hips\n{\n OFFSET 0 0 0\n CHANNELS 6 Xposition Yposition Zposition Yrotation Xrotation Zrotation\n"
        + " End Site\n {\n  OFFSET 0 1 0\n }\n}\n";

    [Fact]
    public async Task Every_command_is_answered()
    {
        using CommandScript server = Answers();
        await using var driver = new Driver();
        string pipe = await driver.CallAsync($"connect-command 127.0.0.1 {server.Port}");
        Assert.NotEqual(Driver.None, pipe);
        Assert.Equal(pipe, await driver.CallAsync($"connect-command 127.0.0.1 {server.Port}"));
        Assert.Equal("0", await driver.CallAsync("get-status " + pipe));

        Assert.Equal("1", await driver.CallAsync($"zero-out {pipe} 1"));
        Assert.Equal("0", await driver.CallAsync($"zero-out {pipe} 7"));
        Assert.Equal("1", await driver.CallAsync($"zero-out-all {pipe}"));
        Assert.Equal("1 4", await driver.CallAsync($"rotation {pipe}"));
        Assert.Equal("1 0.1 0.2 1.2", await driver.CallAsync($"bone-size {pipe} 0"));

        await driver.CallAsync("close " + pipe);
        Assert.Equal("0", await driver.CallAsync($"zero-out-all {pipe}"));
        Assert.Equal("0 6", await driver.CallAsync($"rotation {pipe}"));
        Assert.Equal("0 0 0 0", await driver.CallAsync($"bone-size {pipe} 0"));
        Assert.Empty(driver.Statuses);
        await driver.EndAsync();
    }

    [Fact]
    public async Task The_header_takes_no_more_room_than_there_is()
    {
        string text = Bvh.Replace('\n', '|');
        using CommandScript server = Answers();
        await using var driver = new Driver();
        string pipe = await driver.CallAsync($"connect-command 127.0.0.1 {server.Port}");

        Assert.Equal($"1 {text}0~~~", await driver.CallAsync($"bvh-header {pipe} 0 {Bvh.Length + 2}"));
        Assert.Equal($"1 {text}0~~", await driver.CallAsync($"bvh-header {pipe} 0 {Bvh.Length + 1}"));
        Assert.Equal($"1 {text}~~", await driver.CallAsync($"bvh-header {pipe} 0 {Bvh.Length}"));
        Assert.Equal("1 HIERARCHY~~", await driver.CallAsync($"bvh-header {pipe} 0 9"));
        await driver.CallAsync("close " + pipe);
        Assert.Equal("0 ~~~~~~~~~~~", await driver.CallAsync($"bvh-header {pipe} 0 9"));
        await driver.EndAsync();
    }

    [Fact]
    public async Task Commands_can_be_asked_in_a_frame_callback()
    {
        using CommandScript answers = Answers();
        using var server = new TestServer();
        await using var driver = new Driver();
        string pipe = await driver.CallAsync($"connect-command 127.0.0.1 {answers.Port}");
        (_, TestConnection connection) = await driver.ConnectAsync(server);
        await driver.CallAsync("when frame rotation " + pipe);

        await connection.SendAsync(TestPackets.Motion(1));
        await driver.UntilAsync(() => driver.Reactions.Count == 1);

        Assert.Equal("1 4", driver.Reactions[0]);
        connection.Dispose();
        await driver.EndAsync();
    }

    private static CommandScript Answers() => new(static request => request.Id switch
    {
        1001 => request.ReplyAsync([request.Avatar == 1 ? (byte)1 : (byte)0, 0, 0, 0]),
        1002 => request.ReplyAsync([1, 0, 0, 0]),
        1003 => request.ReplyAsync([4, 0, 0, 0]),
        1004 => request.ReplyAsync([.. Enumerable.Range(1, 12).SelectMany(static i => BitConverter.GetBytes(i / 10f))]),
        _ => request.ReplyAsync(Encoding.ASCII.GetBytes(Bvh)),
    });
}
