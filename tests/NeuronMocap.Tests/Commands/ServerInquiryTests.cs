using System.Text;
using NeuronMocap.Bvh;
using NeuronMocap.Commands;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Commands;

// One question for each connection, whoever asks.
public sealed class ServerInquiryTests
{
    private static readonly byte[] Header = Encoding.ASCII.GetBytes(BvhHierarchyText.Create(SkeletonFormat.Default, new ChannelLayout(hasDisplacement: true, hasReference: false)));

    private static readonly Func<ScriptedRequest, Task> Silence = static _ => Task.CompletedTask;

    [Fact]
    public async Task All_who_ask_share_one_answer()
    {
        using var commands = CommandScript.Always(Header);
        using ServerInquiry inquiry = Create(commands);

        BodyAnswer[] answers = await Task.WhenAll(Enumerable.Range(0, 20).Select(_ => inquiry.GetBodyAsync(0, isRetry: false)));
        BvhSkeletonMap skeleton = await inquiry.GetSkeletonAsync(0, isRetry: true);

        Assert.Equal(1, commands.Requests);
        Assert.All(answers, answer => Assert.Same(skeleton, answer.Skeleton));
        await inquiry.GetBodyAsync(1, isRetry: false);
        Assert.Equal(2, commands.Requests);
    }

    [Fact]
    public async Task A_new_connection_forgets_the_answers()
    {
        using CommandScript commands = CommandScript.InTurn(static request => request.ReplyAsync([1, 0, 0, 0]), static request => request.ReplyAsync([2, 0, 0, 0]));
        using ServerInquiry inquiry = Create(commands);

        Assert.Equal((RotationOrder)1, await inquiry.GetRotationOrderAsync(isRetry: false));
        inquiry.Renew();
        Assert.Equal((RotationOrder)2, await inquiry.GetRotationOrderAsync(isRetry: false));
    }

    [Fact]
    public async Task Who_waits_while_the_connection_changes_gets_the_new_answer()
    {
        using CommandScript commands = CommandScript.InTurn(Silence, static request => request.ReplyAsync([2, 0, 0, 0]));
        using ServerInquiry inquiry = Create(commands);

        Task<RotationOrder> waiting = inquiry.GetRotationOrderAsync(isRetry: false);
        await Limits.UntilAsync(() => commands.Requests == 1);
        inquiry.Renew();
        Assert.Equal((RotationOrder)2, await waiting.Soon());
    }

    [Fact]
    public async Task An_answer_of_no_use_is_asked_for_again_only_on_a_retry()
    {
        using CommandScript commands = CommandScript.InTurn(static request => request.ReplyAsync([9, 0, 0, 0]), static request => request.ReplyAsync([2, 0, 0, 0]));
        using ServerInquiry inquiry = Create(commands);

        NeuronCommandException first = await Assert.ThrowsAsync<NeuronCommandException>(() => inquiry.GetRotationOrderAsync(isRetry: false));
        NeuronCommandException second = await Assert.ThrowsAsync<NeuronCommandException>(() => inquiry.GetRotationOrderAsync(isRetry: false));
        Assert.Same(first, second);
        Assert.Equal((RotationOrder)2, await inquiry.GetRotationOrderAsync(isRetry: true));
        Assert.Equal(2, commands.Requests);
    }

    [Fact]
    public async Task A_server_that_did_not_answer_is_asked_again_by_the_next_who_wants_to_know()
    {
        using CommandScript commands = CommandScript.InTurn(static request => { request.Connection.Close(); return Task.CompletedTask; }, static request => request.ReplyAsync([2, 0, 0, 0]));
        using ServerInquiry inquiry = Create(commands);

        NeuronCommandException exception = await Assert.ThrowsAsync<NeuronCommandException>(() => inquiry.GetRotationOrderAsync(isRetry: false));
        Assert.Equal(CommandFailure.Closed, exception.Reason);
        Assert.Equal((RotationOrder)2, await inquiry.GetRotationOrderAsync(isRetry: false));
    }

    [Fact]
    public async Task The_end_ends_every_question()
    {
        using CommandScript commands = CommandScript.InTurn(Silence);
        ServerInquiry inquiry = Create(commands);
        Task<BodyAnswer> waiting = inquiry.GetBodyAsync(0, isRetry: false);
        await Limits.UntilAsync(() => commands.Requests == 1);

        inquiry.Dispose();
        await Assert.ThrowsAsync<ObjectDisposedException>(() => waiting.Soon());
    }

    private static ServerInquiry Create(CommandScript commands) =>
        new(new NeuronCommandOptions { Port = commands.Port, Timeout = Limits.Unexpected, ConnectTimeout = Limits.Unexpected });
}
