using System.Net;
using System.Net.Sockets;
using NeuronMocap.Commands;
using NeuronMocap.Skeleton;
using NeuronMocap.Tests.Network;
using static NeuronMocap.Tests.Commands.CommandAnswerTests;
using static NeuronMocap.Tests.Commands.CommandCall;

namespace NeuronMocap.Tests.Commands;

// Several callers, cancellation, connecting and stopping.
public class CommandClientTests
{
    private static readonly byte[] ZXY = [4, 0, 0, 0];

    [Fact]
    public async Task Calls_from_many_threads_are_queued_and_each_gets_its_answer()
    {
        int underWay = 0;
        using var server = new CommandScript(async request =>
        {
            Assert.Equal(1, Interlocked.Increment(ref underWay));
            await Task.Yield();
            Interlocked.Decrement(ref underWay);
            await request.ReplyAsync(request.Id == 1003 ? ZXY : Bytes(Sizes(request.Avatar)));
        });
        using NeuronCommandClient client = server.CreateClient();

        await Task.WhenAll(Enumerable.Range(0, 8).Select(thread => Task.Run(async () =>
        {
            for (int i = 0; i < 25; i++)
            {
                int avatar = (thread * 25) + i;
                Assert.Equal(Sizes(avatar), await client.GetBoneDimensionsAsync(avatar));
                if (i % 5 == 0)
                    Assert.Equal(RotationOrder.ZXY, await client.GetRotationOrderAsync());
            }
        }))).Soon();
        Assert.Equal(240, server.Requests);
    }

    [Fact]
    public async Task Calls_run_in_order()
    {
        var order = new List<int>();
        using var server = new CommandScript(request =>
        {
            order.Add(request.Avatar);
            return request.ReplyAsync([1]);
        });
        using NeuronCommandClient client = server.CreateClient();
        await Task.WhenAll(Enumerable.Range(0, 30).Select(avatar => client.ZeroOutAsync(avatar))).Soon();
        Assert.Equal(Enumerable.Range(0, 30), order);
    }

    [Fact]
    public async Task A_blocking_caller_is_answered()
    {
        using var server = CommandScript.Always(ZXY);
        using NeuronCommandClient client = server.CreateClient();
        var answer = new TaskCompletionSource<RotationOrder>(TaskCreationOptions.RunContinuationsAsynchronously);
        new Thread(() => answer.SetResult(client.GetRotationOrderAsync().GetAwaiter().GetResult())) { IsBackground = true }.Start();
        Assert.Equal(RotationOrder.ZXY, await answer.Task.Soon());
    }

    [Fact]
    public async Task A_call_on_the_wire_can_be_cancelled_and_the_next_one_works()
    {
        var asked = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        using var server = CommandScript.InTurn(
            request =>
            {
                asked.SetResult();
                return Task.CompletedTask;
            },
            request => request.ReplyAsync(ZXY));
        using NeuronCommandClient client = server.CreateClient();
        using var cancellation = new CancellationTokenSource();
        Task<RotationOrder> call = client.GetRotationOrderAsync(cancellation.Token);
        await asked.Task.Soon();
        await cancellation.CancelAsync();

        OperationCanceledException exception = await Assert.ThrowsAnyAsync<OperationCanceledException>(() => call.Soon());
        Assert.Equal(cancellation.Token, exception.CancellationToken);
        Assert.Equal(RotationOrder.ZXY, await client.GetRotationOrderAsync().Soon());
    }

    [Fact]
    public async Task A_queued_call_can_be_cancelled_and_is_never_sent()
    {
        var asked = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        var answer = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        using var server = new CommandScript(async request =>
        {
            asked.TrySetResult();
            await answer.Task;
            await request.ReplyAsync(ZXY);
        });
        using NeuronCommandClient client = server.CreateClient();
        using var cancellation = new CancellationTokenSource();
        Task<RotationOrder> first = client.GetRotationOrderAsync();
        Task second = client.ZeroOutAllAsync(cancellation.Token);
        Task<RotationOrder> third = client.GetRotationOrderAsync();
        await asked.Task.Soon();
        await cancellation.CancelAsync();

        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => second.Soon());
        answer.SetResult();
        Assert.Equal(RotationOrder.ZXY, await first.Soon());
        Assert.Equal(RotationOrder.ZXY, await third.Soon());
        Assert.Equal(2, server.Requests);
    }

    [Fact]
    public async Task A_cancelled_token_sends_nothing()
    {
        using var server = CommandScript.Always(ZXY);
        using NeuronCommandClient client = server.CreateClient();
        Task call = client.GetRotationOrderAsync(new CancellationToken(canceled: true));
        Assert.True(call.IsCanceled);
        Assert.Equal(0, server.Connections);
    }

    [Fact]
    public async Task Cancellation_at_any_moment_leaves_a_working_client()
    {
        using var server = new CommandScript(request => request.ReplyAsync(request.Id == 1003 ? ZXY : Bytes(Sizes(request.Avatar))));
        using NeuronCommandClient client = server.CreateClient();
        for (int round = 0; round < 150; round++)
        {
            using var cancellation = new CancellationTokenSource();
            Task<BoneDimensions> cancelled = client.GetBoneDimensionsAsync(round, cancellation.Token);
            Thread.SpinWait(round * 40);
            cancellation.Cancel();
            try
            {
                Assert.Equal(Sizes(round), await cancelled.Soon());
            }
            catch (OperationCanceledException)
            {
                // In time.
            }

            Assert.Equal(Sizes(round + 1), await client.GetBoneDimensionsAsync(round + 1).Soon());
        }
    }

    [Fact]
    public async Task A_refused_connection_is_reported()
    {
        int port;
        using (var server = new TestServer())
            port = server.Port;
        using var client = new NeuronCommandClient("127.0.0.1", port);

        await FailsAsync(client.GetRotationOrderAsync(), CommandFailure.Refused, "Check the command port");
        await FailsAsync(client.ConnectAsync(), CommandFailure.Refused, "refused the connection");
    }

    [Fact]
    public async Task A_connection_timeout_is_reported()
    {
        using var blackHole = new BlackHole();
        using var client = new NeuronCommandClient(
            new NeuronCommandOptions { Port = blackHole.Port, ConnectTimeout = TimeSpan.FromMilliseconds(100) });
        await FailsAsync(client.ConnectAsync(), CommandFailure.NotConnected, "did not answer within 0.1 s");
    }

    [Theory]
    [InlineData(SocketError.HostNotFound)]
    [InlineData(null)]
    public async Task An_unknown_host_is_reported(SocketError? error)
    {
        using var client = new NeuronCommandClient("suit-pc")
        {
            Resolve = _ => throw (error is { } code ? new SocketException((int)code) : new ArgumentException("too long", nameof(error))),
        };
        await FailsAsync(client.GetRotationOrderAsync(), CommandFailure.HostNotFound, "'suit-pc' has no address");
        using var empty = new NeuronCommandClient("suit-pc") { Resolve = static _ => [] };
        await FailsAsync(empty.GetRotationOrderAsync(), CommandFailure.HostNotFound, "'suit-pc' has no address");
    }

    [Fact]
    public async Task All_addresses_of_a_name_are_tried()
    {
        Loopback.NeedManyAddresses();
        using var server = CommandScript.Always(ZXY);
        using var client = new NeuronCommandClient("suit-pc", server.Port)
        {
            Resolve = static _ => [IPAddress.Parse("127.0.77.1"), IPAddress.Loopback],
        };
        Assert.Equal(RotationOrder.ZXY, await client.GetRotationOrderAsync().Soon());
    }

    [Fact]
    public async Task A_slow_name_lookup_times_out()
    {
        using var end = new ManualResetEventSlim();
        using var client = new NeuronCommandClient(new NeuronCommandOptions { Host = "suit-pc", ConnectTimeout = TimeSpan.FromMilliseconds(50) })
        {
            Resolve = _ =>
            {
                end.Wait();
                return [];
            },
        };
        await FailsAsync(client.ConnectAsync(), CommandFailure.NotConnected, "could not be resolved within");
        end.Set();
    }

    [Fact]
    public async Task A_client_connects_until_the_server_can_get_the_request()
    {
        using var resolves = new SemaphoreSlim(0);
        using var asked = new SemaphoreSlim(0);
        using var answers = new SemaphoreSlim(0);
        using var server = new CommandScript(async request =>
        {
            asked.Release();
            await answers.WaitAsync();
            await request.ReplyAsync(ZXY);
        });
        using var client = new NeuronCommandClient(new NeuronCommandOptions { Host = "suit-pc", Port = server.Port, Timeout = Limits.Unexpected, ConnectTimeout = Limits.Unexpected })
        {
            Resolve = _ =>
            {
                resolves.Wait();
                return [IPAddress.Loopback];
            },
        };
        Assert.False(client.IsConnecting);

        // A connection carries each command once.
        for (int connection = 1; connection <= 2; connection++)
        {
            Task<RotationOrder> call = client.GetRotationOrderAsync();
            await Limits.UntilAsync(() => client.IsConnecting);
            resolves.Release();
            await asked.WaitAsync(TestContext.Current.CancellationToken).Soon();
            Assert.False(client.IsConnecting);

            answers.Release();
            Assert.Equal(RotationOrder.ZXY, await call.Soon());
            Assert.False(client.IsConnecting);
        }
    }

    [Fact]
    public async Task A_call_that_got_no_connection_counts_as_connecting_until_the_next()
    {
        using var ends = new SemaphoreSlim(0);
        using var client = new NeuronCommandClient(new NeuronCommandOptions { Host = "suit-pc", ConnectTimeout = Limits.Unexpected })
        {
            Resolve = _ =>
            {
                ends.Wait();
                throw new SocketException((int)SocketError.HostNotFound);
            },
        };
        Task[] calls = [client.ZeroOutAllAsync(), client.ZeroOutAllAsync()];
        await Limits.UntilAsync(() => client.IsConnecting);
        ends.Release();
        await FailsAsync(calls[0], CommandFailure.HostNotFound, "suit-pc");
        Assert.True(client.IsConnecting);

        ends.Release();
        await FailsAsync(calls[1], CommandFailure.HostNotFound, "suit-pc");
        await Limits.UntilAsync(() => !client.IsConnecting);
    }

    [Fact]
    public async Task Disposing_ends_running_and_queued_calls()
    {
        var asked = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        using var server = new CommandScript(request =>
        {
            asked.TrySetResult();
            return Task.CompletedTask;
        });
        NeuronCommandClient client = server.CreateClient();
        Task[] calls = [client.GetRotationOrderAsync(), client.ZeroOutAllAsync(), client.GetBvhHeaderAsync(3)];
        await asked.Task.Soon();
        client.Dispose();
        client.Dispose();

        foreach (Task call in calls)
            await Assert.ThrowsAsync<ObjectDisposedException>(() => call.Soon());
        await Assert.ThrowsAsync<ObjectDisposedException>(() => client.GetRotationOrderAsync().Soon());
        await client.DisposeAsync();
    }

    [Fact]
    public async Task Disposing_ends_a_connection_attempt()
    {
        using var blackHole = new BlackHole();
        var client = new NeuronCommandClient(new NeuronCommandOptions { Port = blackHole.Port, ConnectTimeout = TimeSpan.FromMinutes(5) });
        Task call = client.ConnectAsync();
        await client.DisposeAsync().AsTask().Soon();
        await Assert.ThrowsAsync<ObjectDisposedException>(() => call.Soon());
    }

    [Fact]
    public async Task Cancelling_and_disposing_end_the_wait_for_a_name()
    {
        using var end = new ManualResetEventSlim();
        using var cancellation = new CancellationTokenSource();
        var resolving = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        var client = new NeuronCommandClient(new NeuronCommandOptions { Host = "suit-pc", ConnectTimeout = TimeSpan.FromMinutes(5) })
        {
            Resolve = _ =>
            {
                resolving.TrySetResult();
                end.Wait();
                return [];
            },
        };
        Task cancelled = client.GetRotationOrderAsync(cancellation.Token);
        await resolving.Task.Soon();
        await cancellation.CancelAsync();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => cancelled.Soon());

        Task call = client.GetRotationOrderAsync();
        client.Dispose();
        await Assert.ThrowsAsync<ObjectDisposedException>(() => call.Soon());
        end.Set();
    }

    [Fact]
    public async Task Disposing_at_any_moment_ends_every_call()
    {
        using var server = new CommandScript(request => request.ReplyAsync(ZXY));
        for (int round = 0; round < 60; round++)
        {
            NeuronCommandClient client = server.CreateClient();
            Task<RotationOrder>[] calls = [client.GetRotationOrderAsync(), client.GetRotationOrderAsync()];
            Thread.SpinWait(round * 100);
            client.Dispose();
            foreach (Task<RotationOrder> call in calls)
            {
                Exception? exception = await Record.ExceptionAsync(() => call.Soon());
                Assert.True(exception is null or ObjectDisposedException, exception?.ToString());
            }
        }
    }
}
