using System.Collections.Concurrent;
using System.Diagnostics;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

/// <summary>The exception of a handler is traced even if the program listens to no event.</summary>
public sealed class TracedFailureTests
{
    [Theory]
    [InlineData(false, false, 1)]
    [InlineData(true, false, 0)]
    [InlineData(false, true, 0)]
    public async Task The_first_unhandled_handler_exception_is_traced(bool hasFailureHandler, bool hasEventHandler, int traced)
    {
        using var server = new TestServer();
        NeuronReaderOptions options = server.Options();
        options.Name = $"traced {Guid.NewGuid()}";
        using var listener = new Listener(options.Name);
        Trace.Listeners.Add(listener);
        try
        {
            using var reader = new NeuronReader(options);
            reader.MotionReceived += _ => throw new FormatException("a fault of the application");
            if (hasFailureHandler)
                reader.CallbackFailed += _ => { };
            if (hasEventHandler)
                reader.EventReported += _ => { };

            reader.Start();
            using TestConnection connection = await server.AcceptAsync();
            await connection.SendAsync(TestPackets.Motions(0, 5));
            await Limits.UntilAsync(() => reader.GetStatistics().CallbackFailures == 5);
            reader.Dispose();

            Assert.Equal(traced, listener.Lines.Count);
            Assert.All(listener.Lines, static line => Assert.Contains("a fault of the application", line, StringComparison.Ordinal));
        }
        finally
        {
            Trace.Listeners.Remove(listener);
        }
    }

    [Fact]
    public async Task A_throwing_listener_is_harmless()
    {
        using var server = new TestServer();
        NeuronReaderOptions options = server.Options();
        options.Name = $"traced {Guid.NewGuid()}";
        using var listener = new Listener(options.Name) { Throws = true };
        Trace.Listeners.Add(listener);
        try
        {
            using var reader = new NeuronReader(options);
            int frames = 0;
            reader.MotionReceived += _ => throw new FormatException();
            reader.MotionReceived += _ => Interlocked.Increment(ref frames);
            reader.Start();
            using TestConnection connection = await server.AcceptAsync();
            await connection.SendAsync(TestPackets.Motions(0, 5));
            await Limits.UntilAsync(() => Volatile.Read(ref frames) == 5);
            Assert.Single(listener.Lines);
        }
        finally
        {
            Trace.Listeners.Remove(listener);
        }
    }

    // Other tests trace too.
    private sealed class Listener(string name) : TraceListener
    {
        public ConcurrentQueue<string> Lines { get; } = [];

        public bool Throws { get; init; }

        public override void Write(string? message)
        {
        }

        public override void WriteLine(string? message)
        {
            if (message?.Contains(name, StringComparison.Ordinal) != true)
                return;

            Lines.Enqueue(message);
            if (Throws)
                throw new InvalidOperationException("the listener is broken");
        }
    }
}
