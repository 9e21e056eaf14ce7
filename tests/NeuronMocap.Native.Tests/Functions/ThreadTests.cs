using System.Globalization;
using System.Net.Sockets;
using NeuronMocap.Native.Tests.Infrastructure;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Native.Tests.Functions;

// tests/native/threads.c calls the functions from four threads at once.
public sealed class ThreadTests
{
    [Fact]
    public async Task Concurrent_connects_to_one_address_share_a_connection()
    {
        using var server = new TestServer();
        string[] handles = await RunAsync("same", server.Port);
        Assert.Equal(4, handles.Length);
        Assert.NotEqual(Driver.None, Assert.Single(handles.Distinct(StringComparer.Ordinal)));
    }

    [Fact]
    public async Task The_last_error_is_always_terminated_under_concurrent_failures() => Assert.Equal(["0"], await RunAsync("errors", 0));

    [Fact]
    public async Task Concurrent_opening_registering_and_closing_is_safe()
    {
        using var server = new TestServer();
        using var end = new CancellationTokenSource();
        Task serving = ServeAsync(server, end.Token);
        Assert.Equal(["0"], await RunAsync("churn", server.Port));
        await end.CancelAsync();
        await serving.Soon();
    }

    private static async Task<string[]> RunAsync(string what, int port)
    {
        await using NativeProgram program = NativeProgram.Start("threads", what, port.ToString(CultureInfo.InvariantCulture));
        Assert.Equal(0, await program.EndAsync());
        Assert.Empty(program.Errors);
        return [.. program.ReadRest()];
    }

    // Every connection receives frames until it ends.
    private static async Task ServeAsync(TestServer server, CancellationToken cancellationToken)
    {
        byte[] frames = TestPackets.Motions(1, 20);
        var sending = new List<Task>();
        try
        {
            while (true)
                sending.Add(SendUntilClosedAsync(await server.AcceptAsync(cancellationToken), frames));
        }
        catch (OperationCanceledException)
        {
            await Task.WhenAll(sending);
        }
    }

    private static async Task SendUntilClosedAsync(TestConnection connection, byte[] frames)
    {
        try
        {
            while (true)
                await connection.SendAsync(frames);
        }
        catch (SocketException)
        {
            connection.Dispose();
        }
    }
}
