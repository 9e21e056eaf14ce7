using System.Text;
using NeuronMocap.Bvh;
using NeuronMocap.Commands;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Commands;

// One request for each connection, however many callers ask.
public sealed class ServerInquiryTests
{
    private static readonly byte[] Header = Encoding.ASCII.GetBytes(BvhHierarchyText.Create(SkeletonFormat.Default, new ChannelLayout(hasDisplacement: true, hasReference: false)));

    private static readonly Func<ScriptedRequest, Task> Silence = static _ => Task.CompletedTask;

    [Fact]
    public async Task Concurrent_requests_share_one_answer()
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
    public async Task A_new_connection_discards_the_answers()
    {
        using CommandScript commands = CommandScript.InTurn(static request => request.ReplyAsync([1, 0, 0, 0]), static request => request.ReplyAsync([2, 0, 0, 0]));
        using ServerInquiry inquiry = Create(commands);

        Assert.Equal((RotationOrder)1, await inquiry.GetRotationOrderAsync(isRetry: false));
        inquiry.Renew();
        Assert.Equal((RotationOrder)2, await inquiry.GetRotationOrderAsync(isRetry: false));
    }

    [Fact]
    public async Task A_request_pending_across_connections_gets_the_new_answer()
    {
        using CommandScript commands = CommandScript.InTurn(Silence, static request => request.ReplyAsync([2, 0, 0, 0]));
        using ServerInquiry inquiry = Create(commands);

        Task<RotationOrder> waiting = inquiry.GetRotationOrderAsync(isRetry: false);
        await Limits.UntilAsync(() => commands.Requests == 1);
        inquiry.Renew();
        Assert.Equal((RotationOrder)2, await waiting.Soon());
    }

    [Fact]
    public async Task A_useless_answer_is_requested_again_only_on_retry()
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
    public async Task A_timeout_is_retried_by_the_next_request()
    {
        using CommandScript commands = CommandScript.InTurn(static request => { request.Connection.Close(); return Task.CompletedTask; }, static request => request.ReplyAsync([2, 0, 0, 0]));
        using ServerInquiry inquiry = Create(commands);

        NeuronCommandException exception = await Assert.ThrowsAsync<NeuronCommandException>(() => inquiry.GetRotationOrderAsync(isRetry: false));
        Assert.Equal(CommandFailure.Closed, exception.Reason);
        Assert.Equal((RotationOrder)2, await inquiry.GetRotationOrderAsync(isRetry: false));
    }

    [Fact]
    public async Task Ending_fails_every_pending_request()
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
