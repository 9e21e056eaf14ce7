using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

public sealed class StartTimeoutTests
{
    // Each attempt waits longer, because on a busy computer a connection may not be refused within a second.
    [Fact]
    public async Task A_refusal_ends_the_wait_with_its_reason_and_the_reader_continues()
    {
        using var nobody = new RefusingPort();
        ConnectionReason reason = ConnectionReason.None;
        for (int seconds = 1; reason != ConnectionReason.Refused && seconds <= 16; seconds *= 4)
            reason = await RefuseAsync(nobody.Number, seconds);

        Assert.Equal(ConnectionReason.Refused, reason);
    }

    [Fact]
    public async Task A_server_that_does_not_answer_is_named_with_the_settings_to_check()
    {
        using var blackHole = new BlackHole();
        await using var reader = new NeuronReader(new NeuronReaderOptions { Port = blackHole.Port, ConnectTimeout = Limits.Unexpected });
        NeuronConnectionException exception = await FailAsync(reader, TimeSpan.FromSeconds(4));
        Assert.Equal(ConnectionReason.TimedOut, exception.Reason);
        Assert.Contains($"127.0.0.1:{blackHole.Port}", exception.Message, StringComparison.Ordinal);
        Assert.Contains("check Host and Port", exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_connection_in_time_ends_the_wait()
    {
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        await reader.StartAsync(Limits.Unexpected).Soon();
        Assert.True(reader.Status.IsConnected);
    }

    [Fact]
    public async Task A_token_ends_the_wait_as_a_cancellation()
    {
        using var blackHole = new BlackHole();
        await using var reader = new NeuronReader("127.0.0.1", blackHole.Port);
        using var cancellation = new CancellationTokenSource();
        Task start = reader.StartAsync(TimeSpan.FromHours(1), cancellation.Token);
        Assert.False(start.IsCompleted);
        await cancellation.CancelAsync();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => start).Soon();
    }

    [Theory]
    [InlineData(0)]
    [InlineData(-1)]
    [InlineData(25 * 24 * 3600)]
    public async Task A_timeout_out_of_range_is_refused_before_the_start(int seconds)
    {
        using var reader = new NeuronReader("127.0.0.1");
        await Assert.ThrowsAsync<ArgumentOutOfRangeException>(() => reader.StartAsync(TimeSpan.FromSeconds(seconds)));
        Assert.Equal(ConnectionState.Created, reader.Status.State);
    }

    private static async Task<ConnectionReason> RefuseAsync(int port, int seconds)
    {
        await using var reader = new NeuronReader(new NeuronReaderOptions
        {
            Port = port,
            Reconnect = { InitialDelay = TimeSpan.FromMilliseconds(10), MaxDelay = TimeSpan.FromMilliseconds(10) },
        });
        NeuronConnectionException exception = await FailAsync(reader, TimeSpan.FromSeconds(seconds));
        if (exception.Reason != ConnectionReason.Refused)
            return exception.Reason;

        Assert.Equal(ConnectionReason.Refused, exception.LastStatus?.Reason);
        Assert.Contains($"no connection within {seconds} s", exception.Message, StringComparison.Ordinal);
        Assert.Contains("refused the connection", exception.Message, StringComparison.Ordinal);
        Assert.Contains("check that the port is the same", exception.Message, StringComparison.Ordinal);
        Assert.NotEqual(ConnectionState.Stopped, reader.Status.State);
        Assert.False(reader.Completion.IsCompleted);
        return exception.Reason;
    }

    private static async Task<NeuronConnectionException> FailAsync(NeuronReader reader, TimeSpan timeout) =>
        await Assert.ThrowsAsync<NeuronConnectionException>(() => reader.StartAsync(timeout)).Soon();
}
