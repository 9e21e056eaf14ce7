using NeuronMocap.Commands;
using NeuronMocap.Server.Faults;
using NeuronMocap.Tests.Commands;
using static NeuronMocap.Server.Tests.CommandServerTests;

namespace NeuronMocap.Server.Tests;

// Every quirk of the server with the client: the right answer, or an exception with its reason.
public sealed class CommandQuirkTests
{
    [Fact]
    public Task A_number_that_is_not_repeated() => AnswersAsync(static quirks => quirks.ReplyId = 0);

    [Fact]
    public Task A_number_of_no_command() => FailsAsync(static quirks => quirks.ReplyId = 7, CommandFailure.InvalidReply);

    [Fact]
    public Task Another_commands_number() => FailsAsync(static quirks => quirks.ReplyId = 1001, CommandFailure.TimedOut);

    [Fact]
    public Task Any_type_and_any_reserved_field() => AnswersAsync(static quirks =>
    {
        quirks.CommandType = 0xFFAA;
        quirks.Reserved = 0xFFFFFFFF;
    });

    [Fact]
    public Task A_size_that_is_too_short() => FailsAsync(static quirks => quirks.PayloadSize = 0, CommandFailure.Rejected);

    [Fact]
    public Task A_size_that_is_too_long() => AnswersAsync(static quirks => quirks.PayloadSize = 60);

    [Fact]
    public Task A_negative_size() => FailsAsync(static quirks => quirks.AnnouncedSize = -4, CommandFailure.InvalidReply);

    [Fact]
    public Task A_size_beyond_the_data() => FailsAsync(static quirks => quirks.AnnouncedSize = 400, CommandFailure.TimedOut);

    [Fact]
    public Task Two_answers_to_everything() => AnswersAsync(static quirks => quirks.Answers = 2);

    [Fact]
    public Task No_answer_at_all() => FailsAsync(static quirks => quirks.Answers = 0, CommandFailure.TimedOut);

    [Fact]
    public Task Something_unasked_for_before_every_answer() => AnswersAsync(static quirks => quirks.Unsolicited = true);

    [Fact]
    public Task The_connection_ends_instead_of_answering() => FailsAsync(static quirks => quirks.CloseInstead = true, CommandFailure.Closed);

    [Fact]
    public Task Single_bytes() => AnswersAsync(static quirks => quirks.Fragment = 1);

    [Fact]
    public Task A_pause_before_every_answer() => AnswersAsync(static quirks => quirks.Delay = TimeSpan.FromMilliseconds(5));

    private static async Task AnswersAsync(Action<CommandReplyQuirks> change)
    {
        using Broadcaster broadcaster = CreateBroadcaster(options => options.RotationOrder = RotationOrder.ZYX);
        using CommandServer server = Start(broadcaster, options => change(options.Quirks));
        using NeuronCommandClient client = CreateClient(server);
        for (int i = 0; i < 3; i++)
        {
            Assert.Equal(RotationOrder.ZYX, await client.GetRotationOrderAsync().Soon());
            Assert.Equal(0.25f, (await client.GetBoneDimensionsAsync(i).Soon()).Forearm, 1e-6);
            await client.ZeroOutAsync(i).Soon();
        }
    }

    private static async Task FailsAsync(Action<CommandReplyQuirks> change, CommandFailure reason)
    {
        using Broadcaster broadcaster = CreateBroadcaster();
        using CommandServer server = Start(broadcaster, options => change(options.Quirks));
        using NeuronCommandClient client = CreateClient(
            server, options => options.Timeout = reason == CommandFailure.TimedOut ? TimeSpan.FromMilliseconds(60) : Limits.Unexpected);
        for (int i = 0; i < 3; i++)
            await CommandCall.FailsAsync(client.GetRotationOrderAsync(), reason, "127.0.0.1");
    }
}
