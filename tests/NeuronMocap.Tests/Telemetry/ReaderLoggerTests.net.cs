using Microsoft.Extensions.Logging;
using NeuronMocap.Telemetry;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Telemetry;

public sealed class ReaderLoggerTests
{
    [Fact]
    public async Task A_run_logs_each_change_and_kind_of_loss()
    {
        using var server = new TestServer();
        using var log = new LineLog();
        NeuronReaderOptions options = server.Options();
        options.Name = "stage left";
        options.LoggerFactory = log;
        using var reader = new NeuronReader(options);
        using FrameQueue queue = reader.OpenQueue(1, "draw");
        reader.MotionReceived += _ => throw new InvalidOperationException("no disk");
        reader.Start();
        using (TestConnection connection = await server.AcceptAsync())
            await connection.SendAsync(TestPackets.Join(TestPackets.Motion(1), new byte[100], TestPackets.Motion(4)));

        await reader.Completion.Soon();
        (LogLevel Level, EventId Id, Dictionary<string, object?> Fields, string Text, Exception? Exception)[] lines = log.Lines;
        Assert.Equal([1, 2, 3, 6, 10, 11, 12, 13], lines.Select(line => line.Id.Id).Distinct().Order());
        Assert.All(lines, line => Assert.Equal("stage left", line.Fields["Reader"]));
        Assert.All(lines, line => Assert.Equal(((ReaderEventId)line.Id.Id).ToString(), line.Id.Name));
        Assert.Equal(("Stopped", "ClosedByPeer"), (Field(6, "State"), Field(6, "Reason")));
        Assert.Equal(LogLevel.Information, lines.First(line => line.Id.Id == 6).Level);
        Assert.Equal((2L, 2L), (Field(10, "Count"), Field(10, "Total")));
        Assert.Equal("draw", Field(11, "Consumer"));
        Assert.Equal("NoTokens", Field(12, "SkipReason"));
        Assert.Equal("no disk", lines.First(line => line.Id.Id == 13).Exception!.Message);
        Assert.Contains("Receiving from", lines.First(line => line.Id.Id == 3).Text, StringComparison.Ordinal);

        object? Field(int id, string name) => lines.First(line => line.Id.Id == id).Fields[name];
    }

    [Fact]
    public void Silence_and_waiting_log_reason_attempt_and_delay()
    {
        using var log = new LineLog();
        var logger = new ReaderLogger(log);
        foreach (ConnectionState state in (ConnectionState[])[ConnectionState.Silent, ConnectionState.Waiting])
        {
            var status = new ConnectionStatus(state, ConnectionReason.TimedOut, "No answer.") { Attempt = 3, RetryIn = TimeSpan.FromSeconds(2.5) };
            logger.Write(new ReaderEvent((ReaderEventId)state, ReaderEventLevel.Warning, "r", status.Message) { Status = status });
        }

        Assert.Equal([4, 5], log.Lines.Select(line => line.Id.Id));
        Assert.All(log.Lines, line => Assert.Equal("TimedOut", line.Fields["Reason"]));
        Assert.Equal((3, 2.5), (log.Lines[1].Fields["Attempt"], log.Lines[1].Fields["RetrySeconds"]));
    }

    [Fact]
    public async Task A_throwing_logger_is_counted_and_isolated()
    {
        using var server = new TestServer();
        using var log = new LineLog { Throws = true };
        NeuronReaderOptions options = server.Options();
        options.LoggerFactory = log;
        using var reader = new NeuronReader(options);
        reader.Start();
        using (TestConnection connection = await server.AcceptAsync())
        {
            await connection.SendAsync(TestPackets.Motions(1, 10));
            await reader.WaitForFramesAsync(10);
        }

        await reader.Completion.Soon();
        Assert.Equal(10, reader.GetStatistics().MotionFrames);
        Assert.InRange(reader.GetStatistics().CallbackFailures, 4, 100);
    }

    private sealed class LineLog : ILoggerFactory, ILogger
    {
        private readonly object _lock = new();
        private readonly List<(LogLevel, EventId, Dictionary<string, object?>, string, Exception?)> _lines = [];

        public bool Throws { get; init; }

        public (LogLevel Level, EventId Id, Dictionary<string, object?> Fields, string Text, Exception? Exception)[] Lines
        {
            get
            {
                lock (_lock)
                    return [.. _lines];
            }
        }

        public ILogger CreateLogger(string categoryName)
        {
            Assert.Equal("NeuronMocap.NeuronReader", categoryName);
            return this;
        }

        public void AddProvider(ILoggerProvider provider)
        {
        }

        public bool IsEnabled(LogLevel logLevel) => true;

        public IDisposable? BeginScope<TState>(TState state)
            where TState : notnull => null;

        public void Log<TState>(LogLevel logLevel, EventId eventId, TState state, Exception? exception, Func<TState, Exception?, string> formatter)
        {
            if (Throws)
                throw new InvalidOperationException("no disk");

            Dictionary<string, object?> fields = ((IEnumerable<KeyValuePair<string, object?>>)state!).ToDictionary();
            lock (_lock)
                _lines.Add((logLevel, eventId, fields, formatter(state, exception), exception));
        }

        public void Dispose()
        {
        }
    }
}
