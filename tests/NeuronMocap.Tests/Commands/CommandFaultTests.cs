using System.Net.Sockets;
using System.Text;
using NeuronMocap.Bvh;
using NeuronMocap.Commands;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Network;
using static NeuronMocap.Tests.Commands.CommandAnswerTests;
using static NeuronMocap.Tests.Commands.CommandCall;

namespace NeuronMocap.Tests.Commands;

// Whatever a server does, a call ends with its own answer or with an exception, and the next call works.
public class CommandFaultTests
{
    private static readonly TimeSpan Short = TimeSpan.FromMilliseconds(60);
    private static readonly byte[] ZXY = [4, 0, 0, 0];
    private static readonly byte[] XYZ = [2, 0, 0, 0];

    [Fact]
    public async Task A_timeout_gives_the_next_call_a_new_connection()
    {
        ScriptedRequest? unanswered = null;
        using var server = CommandScript.InTurn(
            request =>
            {
                unanswered = request;
                return Task.CompletedTask;
            },
            async request =>
            {
                // The first answer comes now, when it could be mistaken for this one.
                await TryAsync(() => unanswered!.ReplyAsync(XYZ));
                await request.ReplyAsync(ZXY);
            });
        using NeuronCommandClient client = server.CreateClient(static options => options.Timeout = Short);

        await FailsAsync(client.GetRotationOrderAsync(), CommandFailure.TimedOut, "NeuronCommandOptions.Timeout");
        Assert.Equal(RotationOrder.ZXY, await RepeatAsync(client.GetRotationOrderAsync));

        // A busy machine may end a call after its connection and before its request.
        Assert.InRange(server.Requests, 2, server.Connections);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(15)]
    [InlineData(16)]
    [InlineData(63)]
    public async Task A_partial_reply_times_out(int length)
    {
        using var server = new CommandScript(request => request.SendAsync(CommandScript.Packet(Bytes(Sizes(0)), request.Id)[..length]));
        using NeuronCommandClient client = server.CreateClient(static options => options.Timeout = Short);

        // On a busy machine, even the start may be late.
        string message = string.Empty;
        while (!message.Contains("not complete", StringComparison.Ordinal))
            message = (await FailsAsync(client.GetBoneDimensionsAsync(0), CommandFailure.TimedOut, "within 0.06 s")).Message;
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task A_lost_connection_is_reported_and_the_next_call_works(bool reset)
    {
        byte[] packet = CommandScript.Packet(ZXY, 1003);
        for (int length = 0; length < packet.Length; length++)
        {
            using var server = CommandScript.InTurn(
                async request =>
                {
                    await request.SendAsync(packet[..length]);
                    if (reset)
                        request.Connection.Reset();
                    else
                        request.Connection.Close();
                },
                request => request.ReplyAsync(XYZ));
            using NeuronCommandClient client = server.CreateClient();

            await FailsAsync(client.GetRotationOrderAsync(), CommandFailure.Closed, "closed the connection");
            Assert.Equal(RotationOrder.XYZ, await client.GetRotationOrderAsync().Soon());
        }
    }

    [Fact]
    public async Task A_server_that_closes_after_each_answer_gets_new_connections()
    {
        using var server = new CommandScript(async request =>
        {
            await request.ReplyAsync(request.Id == 1003 ? ZXY : [1]);
            request.Connection.Close();
        });
        using NeuronCommandClient client = server.CreateClient();
        for (int i = 0; i < 20; i++)
        {
            Assert.Equal(RotationOrder.ZXY, await client.GetRotationOrderAsync().Soon());
            await client.ZeroOutAllAsync().Soon();
        }
    }

    [Fact]
    public async Task A_connection_that_ends_during_a_request_is_replaced()
    {
        using var server = CommandScript.InTurn(
            request => request.ReplyAsync(ZXY),
            request =>
            {
                request.Connection.Reset();
                return Task.CompletedTask;
            },
            request => request.ReplyAsync([1]));
        using NeuronCommandClient client = server.CreateClient();

        Assert.Equal(RotationOrder.ZXY, await client.GetRotationOrderAsync().Soon());
        await client.ZeroOutAllAsync().Soon();
        Assert.Equal(3, server.Requests);
        Assert.Equal(2, server.Connections);
    }

    [Fact]
    public async Task Only_different_commands_share_a_connection()
    {
        using var server = new CommandScript(request => request.ReplyAsync(request.Id switch
        {
            1003 => ZXY,
            1004 => Bytes(Sizes(request.Avatar)),
            _ => [1],
        }));
        using NeuronCommandClient client = server.CreateClient();
        await client.ConnectAsync().Soon();
        await client.GetRotationOrderAsync().Soon();
        await client.ZeroOutAllAsync().Soon();
        await client.ZeroOutAsync(1).Soon();
        await client.GetBoneDimensionsAsync(1).Soon();
        Assert.Equal(1, server.Connections);

        Assert.Equal(Sizes(2), await client.GetBoneDimensionsAsync(2).Soon());
        Assert.Equal(2, server.Connections);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public async Task A_duplicate_answer_is_never_used_for_another_call(bool isLate)
    {
        byte[]? second = null;
        using var server = new CommandScript(async request =>
        {
            // Late: after the next request arrives, and before its answer.
            byte[] packet = CommandScript.Packet(request.Id == 1003 ? ZXY : Bytes(Sizes(request.Avatar)), request.Id);
            byte[] late = second ?? [];
            second = isLate ? packet : null;
            await request.SendAsync([.. late, .. packet, .. isLate ? [] : packet]);
        });
        using NeuronCommandClient client = server.CreateClient();
        for (int avatar = 0; avatar < 10; avatar++)
        {
            Assert.Equal(Sizes(avatar), await client.GetBoneDimensionsAsync(avatar).Soon());
            Assert.Equal(RotationOrder.ZXY, await client.GetRotationOrderAsync().Soon());
            second = null;
        }
    }

    [Fact]
    public async Task A_late_answer_to_another_call_is_skipped()
    {
        using var server = new CommandScript(async request =>
        {
            await request.ReplyAsync([1], id: 1001);
            await request.ReplyAsync(Bytes(Sizes(9)), id: 1004);
            await request.ReplyAsync(ZXY);
        });
        using NeuronCommandClient client = server.CreateClient();
        Assert.Equal(RotationOrder.ZXY, await client.GetRotationOrderAsync().Soon());
    }

    [Fact]
    public async Task An_unknown_command_number_is_accepted_only_by_option()
    {
        using var server = new CommandScript(request => request.ReplyAsync(ZXY, id: 77));
        using NeuronCommandClient strict = server.CreateClient();
        await FailsAsync(strict.GetRotationOrderAsync(), CommandFailure.InvalidReply, "NeuronCommandOptions.AcceptAnyReplyId");

        using NeuronCommandClient lenient = server.CreateClient(static options => options.AcceptAnyReplyId = true);
        Assert.Equal(RotationOrder.ZXY, await lenient.GetRotationOrderAsync().Soon());
        Assert.Equal(RotationOrder.ZXY, await lenient.GetRotationOrderAsync().Soon());
    }

    // If any number is accepted, the number cannot detect a repeated answer.
    [Fact]
    public async Task A_duplicate_answer_is_never_used_when_any_number_is_accepted()
    {
        using var server = new CommandScript(request =>
        {
            byte[] refusal = CommandScript.Packet([0, 0, 0, 0], request.Id);
            byte[] late = request is { Id: not 1003, ConnectionNumber: 0 } ? CommandScript.Packet(ZXY, 1003) : [];
            return request.SendAsync(request.Id == 1003 ? CommandScript.Packet(ZXY, 1003) : [.. late, .. refusal]);
        });
        using NeuronCommandClient client = server.CreateClient(static options => options.AcceptAnyReplyId = true);
        Assert.Equal(RotationOrder.ZXY, await client.GetRotationOrderAsync().Soon());
        await FailsAsync(client.ZeroOutAllAsync(), CommandFailure.Rejected, "did not zero out");
    }

    [Fact]
    public async Task A_server_that_does_not_echo_numbers_gets_a_connection_per_request()
    {
        using var server = new CommandScript(request => request.ReplyAsync(request.Id == 1003 ? ZXY : [1], id: 0));
        using NeuronCommandClient client = server.CreateClient();
        Assert.Equal(RotationOrder.ZXY, await client.GetRotationOrderAsync().Soon());
        await client.ZeroOutAllAsync().Soon();
        await client.ZeroOutAsync(0).Soon();
        Assert.Equal(3, server.Connections);
    }

    [Theory]
    [InlineData(-1, "1 bytes")]
    [InlineData(int.MinValue, "bytes")]
    [InlineData(100_001, "NeuronCommandOptions.MaxReplySize")]
    [InlineData(int.MaxValue, "NeuronCommandOptions.MaxReplySize")]
    public async Task An_impossible_size_is_reported_at_once(int size, string told)
    {
        using var server = CommandScript.InTurn(
            request => request.SendAsync(CommandScript.Packet(ZXY, request.Id, size)),
            request => request.ReplyAsync(ZXY));
        using NeuronCommandClient client = server.CreateClient();
        await FailsAsync(client.GetRotationOrderAsync(), CommandFailure.InvalidReply, told);
        Assert.Equal(RotationOrder.ZXY, await client.GetRotationOrderAsync().Soon());
    }

    [Fact]
    public async Task The_reply_limit_can_be_raised_to_the_vendors()
    {
        byte[] header = Encoding.ASCII.GetBytes(BvhHierarchyText.Create(SkeletonFormat.Default, default));
        byte[] payload = [.. header, .. Enumerable.Repeat((byte)'\n', 200_016 - header.Length)];
        using var server = CommandScript.Always(payload);
        using NeuronCommandClient client = server.CreateClient(static options => options.MaxReplySize = 200_016);
        Assert.Equal(200_016, (await client.GetBvhHeaderTextAsync(0).Soon()).Length);
    }

    [Fact]
    public async Task Noise_before_a_reply_is_skipped()
    {
        using var server = new CommandScript(request => request.SendAsync(
            [1, 2, 0xFF, 0xAA, 3, .. CommandScript.Packet([], 1003)[..15], .. CommandScript.Packet(ZXY, request.Id)]));
        using NeuronCommandClient client = server.CreateClient();
        for (int i = 0; i < 3; i++)
            Assert.Equal(RotationOrder.ZXY, await client.GetRotationOrderAsync().Soon());
    }

    [Fact]
    public async Task Unsolicited_data_forces_a_new_connection()
    {
        TestConnection? connection = null;
        using var server = new CommandScript(request =>
        {
            connection = request.Connection;
            return request.ReplyAsync(request.Id == 1003 ? ZXY : [1]);
        });
        using NeuronCommandClient client = server.CreateClient();
        await client.ZeroOutAllAsync().Soon();
        await connection!.SendAsync(CommandScript.Packet(XYZ, 1003));
        await WaitForArrivalAsync();

        Assert.Equal(RotationOrder.ZXY, await client.GetRotationOrderAsync().Soon());
        Assert.Equal(2, server.Connections);
    }

    [Fact]
    public async Task A_data_port_is_reported_as_no_command_port()
    {
        // Frames come before and after the request, all the time.
        byte[] frame = TestPackets.Motion(frame: 1);
        using var end = new CancellationTokenSource();
        using var server = new CommandScript(
            static _ => Task.CompletedTask,
            async connection =>
            {
                _ = SendForEverAsync(connection, frame, end.Token);
                await connection.SendAsync(frame);
            });
        using NeuronCommandClient client = server.CreateClient(static options => options.Timeout = Short);

        NeuronCommandException exception = await Assert.ThrowsAsync<NeuronCommandException>(() => client.GetRotationOrderAsync().Soon());
        await end.CancelAsync();
        Assert.True(exception.Reason is CommandFailure.InvalidReply or CommandFailure.TimedOut, exception.Message);
        Assert.Contains("not the port of the stream", exception.Message, StringComparison.Ordinal);
    }

    private static async Task SendForEverAsync(TestConnection connection, byte[] bytes, CancellationToken cancellationToken)
    {
        try
        {
            while (!cancellationToken.IsCancellationRequested)
            {
                await connection.SendAsync(bytes);
                await Task.Delay(1, cancellationToken);
            }
        }
        catch (Exception exception) when (exception is SocketException or ObjectDisposedException or OperationCanceledException)
        {
            // The client closed the connection.
        }
    }

    // Repeats until the call succeeds in time. On a busy machine an answer may be late.
    private static async Task<T> RepeatAsync<T>(Func<CancellationToken, Task<T>> call)
    {
        while (true)
        {
            try
            {
                return await call(TestContext.Current.CancellationToken).Soon();
            }
            catch (NeuronCommandException exception) when (exception.Reason == CommandFailure.TimedOut)
            {
                // Tries once more.
            }
        }
    }

    private static async Task TryAsync(Func<Task> send)
    {
        try
        {
            await send();
        }
        catch (Exception exception) when (exception is SocketException or ObjectDisposedException)
        {
            // The connection is closed, as expected.
        }
    }

    // On Linux, data sent over loopback arrives at once. Elsewhere the system may take a moment.
    private static Task WaitForArrivalAsync() => OperatingSystem.IsLinux() ? Task.CompletedTask : Task.Delay(50);
}
