using System.Collections.Concurrent;
using System.Diagnostics.CodeAnalysis;
using System.Diagnostics.Metrics;
using Microsoft.Extensions.Configuration;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Diagnostics.HealthChecks;
using Microsoft.Extensions.Hosting;
using Microsoft.Extensions.Logging;
using Microsoft.Extensions.Options;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Hosting.Tests;

public sealed class HostTests
{
    [Fact]
    public async Task The_reader_starts_and_stops_with_the_host()
    {
        using var server = new TestServer();
        using IHost host = Build(builder => builder.Services.AddNeuronReader(), ("NeuronReader:Port", Text(server.Port)));
        var reader = host.Services.GetRequiredService<NeuronReader>();
        Assert.Equal(ConnectionState.Created, reader.Status.State);

        await host.StartAsync().Soon();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motions(1, 5));
        await reader.WaitForFramesAsync(5);
        await host.StopAsync().Soon();

        Assert.Equal((ConnectionState.Stopped, ConnectionReason.Requested), (reader.Status.State, reader.Status.Reason));
        Assert.Equal(5, reader.GetStatistics().MotionFrames);
    }

    [Fact]
    public async Task Metrics_can_be_exported_until_the_host_is_disposed()
    {
        using var server = new TestServer();
        string name = $"last-figures-{Guid.NewGuid():N}";
        using var listener = new MeterListener();
        long frames = -1;
        listener.InstrumentPublished = (instrument, meters) =>
        {
            if (instrument is { Name: "neuron.reader.frames", Meter.Name: "NeuronMocap" })
                meters.EnableMeasurementEvents(instrument);
        };
        listener.SetMeasurementEventCallback<long>((_, value, tags, _) =>
        {
            if (tags.Contains(new("neuron.reader.name", name)) && tags.Contains(new("neuron.frame.kind", "motion")))
                frames = value;
        });
        listener.Start();
        using (IHost host = Build(builder => builder.Services.AddNeuronReader(), ("NeuronReader:Port", Text(server.Port)), ("NeuronReader:Name", name)))
        {
            await host.StartAsync().Soon();
            using TestConnection connection = await server.AcceptAsync();
            await connection.SendAsync(TestPackets.Motions(1, 5));
            await host.Services.GetRequiredService<NeuronReader>().WaitForFramesAsync(5);
            await host.StopAsync().Soon();
            listener.RecordObservableInstruments();
            Assert.Equal(5, frames);
        }

        frames = -1;
        listener.RecordObservableInstruments();
        Assert.Equal(-1, frames);
    }

    [Fact]
    public async Task A_queue_opened_in_a_constructor_gets_the_first_frame_and_ends_with_the_reader()
    {
        using var server = new TestServer();
        using IHost host = Build(
            builder => builder.Services.AddNeuronReader().AddSingleton<Consumer>().AddHostedService(services => services.GetRequiredService<Consumer>()),
            ("NeuronReader:Port", Text(server.Port)));
        var consumer = host.Services.GetRequiredService<Consumer>();

        await host.StartAsync().Soon();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motions(1, 200));
        await Limits.UntilAsync(() => consumer.Frames.Count == 200);
        await host.StopAsync().Soon();
        await consumer.ExecuteTask!.Soon();

        Assert.Equal(Enumerable.Range(1, 200).Select(index => (uint?)index), consumer.Frames);
    }

    [Theory]
    [InlineData("Port", "0", "Port is 0; it must be 1 to 65535.")]
    [InlineData("ConnectTimeout", "0", "ConnectTimeout is 00:00:00; it must be more than zero and at most 5 minutes.")]
    [InlineData("Host", " ", "Host is empty; give the name or address of the computer that runs Axis Neuron.")]
    [InlineData("Reconnect:MaxDelay", "0.001", "Reconnect.MaxDelay is 00:00:00.0010000; it must not be less than InitialDelay, 00:00:00.2500000.")]
    [InlineData("Prot", "7001", "Prot is not a setting of a reader; use one of")]
    public async Task Invalid_options_stop_the_host_from_starting(string key, string value, string expected)
    {
        using IHost host = Build(builder => builder.Services.AddNeuronReader(), ($"NeuronReader:{key}", value));
        OptionsValidationException exception = await Assert.ThrowsAsync<OptionsValidationException>(() => host.StartAsync());
        Assert.StartsWith(expected, Assert.Single(exception.Failures), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Code_overrides_configuration_and_is_validated()
    {
        using IHost host = Build(builder => builder.Services.AddNeuronReader(options => options.MaxValues = 0), ("NeuronReader:MaxValues", "100"));
        OptionsValidationException exception = await Assert.ThrowsAsync<OptionsValidationException>(() => host.StartAsync());
        Assert.Equal("MaxValues is 0; it must be 1 to 1,000,000.", Assert.Single(exception.Failures));
    }

    [Fact]
    public async Task Each_reader_has_its_own_section_name_and_key()
    {
        using var left = new TestServer();
        using var right = new TestServer();
        using IHost host = Build(
            builder => builder.Services.AddNeuronReader("left").AddNeuronReader("right", options => options.Name = "right of stage"),
            ("NeuronReaders:left:Port", Text(left.Port)),
            ("NeuronReaders:right:Port", Text(right.Port)));
        await host.StartAsync().Soon();
        using TestConnection first = await left.AcceptAsync();
        using TestConnection second = await right.AcceptAsync();
        await second.SendAsync(TestPackets.Motions(1, 3));

        await host.Services.GetRequiredKeyedService<NeuronReader>("right").WaitForFramesAsync(3);
        var other = host.Services.GetRequiredKeyedService<NeuronReader>("left");
        Assert.Equal(0, other.GetStatistics().MotionFrames);
        Assert.Equal(("left", "right of stage"), (other.Name, host.Services.GetRequiredKeyedService<NeuronReader>("right").Name));
        Assert.Null(host.Services.GetService<NeuronReader>());
        await host.StopAsync().Soon();
        Assert.Equal(ConnectionState.Stopped, other.Status.State);
    }

    [Fact]
    public async Task A_fault_of_a_named_reader_names_it()
    {
        using IHost host = Build(builder => builder.Services.AddNeuronReader("left"), ("NeuronReaders:left:Port", "70000"));
        OptionsValidationException exception = await Assert.ThrowsAsync<OptionsValidationException>(() => host.StartAsync());
        Assert.Equal("left: Port is 70000; it must be 1 to 65535.", Assert.Single(exception.Failures));
    }

    [Fact]
    public async Task The_reader_logs_to_the_host()
    {
        using var server = new TestServer();
        using var log = new LogLines();
        using IHost host = Build(
            builder =>
            {
                builder.Logging.AddProvider(log);
                builder.Services.AddNeuronReader(options => options.Name = "stage");
            },
            ("NeuronReader:Port", Text(server.Port)));
        await host.StartAsync().Soon();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        await Limits.UntilAsync(() => log.Lines.Any(line => line.StartsWith("NeuronMocap.NeuronReader 3 stage: Receiving", StringComparison.Ordinal)));
        await host.StopAsync().Soon();
        Assert.Contains(log.Lines, line => line.StartsWith("NeuronMocap.NeuronReader 6 stage: Stopped (Requested)", StringComparison.Ordinal));
    }

    // A handler that hangs is abandoned after the reader's own time limit. If the host's time limit is shorter, it applies first.
    [Fact]
    public async Task Stopping_respects_the_shutdown_timeout()
    {
        using var server = new TestServer();
        using var release = new ManualResetEventSlim();
        using var entered = new ManualResetEventSlim();
        using IHost host = Build(
            builder =>
            {
                builder.Services.AddNeuronReader();
                builder.Services.Configure<HostOptions>(options => options.ShutdownTimeout = TimeSpan.FromMilliseconds(100));
            },
            ("NeuronReader:Port", Text(server.Port)));
        host.Services.GetRequiredService<NeuronReader>().MotionReceived += _ =>
        {
            entered.Set();
            release.Wait(Limits.Unexpected);
        };
        await host.StartAsync().Soon();
        using TestConnection connection = await server.AcceptAsync();
        await connection.SendAsync(TestPackets.Motion(1));
        Assert.True(entered.Wait(Limits.Unexpected));

        await host.StopAsync().Soon();
        Assert.False(host.Services.GetRequiredService<NeuronReader>().Completion.IsCompleted);
        release.Set();
        await host.Services.GetRequiredService<NeuronReader>().Completion.Soon();
    }

    [Fact]
    public async Task Health_follows_the_state()
    {
        using var server = new TestServer();
        using IHost host = Build(
            builder =>
            {
                builder.Services.AddNeuronReader(options => options.Name = "stage");
                builder.Services.AddHealthChecks().AddNeuronReader();
            },
            ("NeuronReader:Port", Text(server.Port)));
        var health = host.Services.GetRequiredService<HealthCheckService>();
        var reader = host.Services.GetRequiredService<NeuronReader>();
        Assert.Equal(HealthStatus.Unhealthy, (await health.CheckHealthAsync()).Status);

        await host.StartAsync().Soon();
        using TestConnection connection = await server.AcceptAsync();
        await Limits.UntilAsync(() => reader.Status.State == ConnectionState.Connected);
        Assert.Equal(HealthStatus.Degraded, (await health.CheckHealthAsync()).Status);

        await connection.SendAsync(TestPackets.Motion(1));
        await reader.WaitForFramesAsync(1);
        HealthReportEntry entry = (await health.CheckHealthAsync()).Entries["neuron-reader"];
        Assert.Equal((HealthStatus.Healthy, "stage", "Receiving"), (entry.Status, entry.Data["reader"], entry.Data["state"]));

        await host.StopAsync().Soon();
        Assert.Equal(HealthStatus.Unhealthy, (await health.CheckHealthAsync()).Status);
    }

    [Fact]
    public void Wrong_arguments_are_refused()
    {
        Assert.Throws<ArgumentNullException>(() => NeuronReaderServiceCollectionExtensions.AddNeuronReader(null!));
        Assert.Throws<ArgumentException>(() => new ServiceCollection().AddNeuronReader(" "));
        Assert.Throws<ArgumentNullException>(() => NeuronReaderHealthCheckExtensions.AddNeuronReader(null!));
    }

    [Fact]
    public void The_options_have_their_defaults_without_configuration()
    {
        using ServiceProvider services = new ServiceCollection().AddNeuronReader().BuildServiceProvider();
        Assert.StartsWith("127.0.0.1:7001", services.GetRequiredService<NeuronReader>().Name, StringComparison.Ordinal);
    }

    private static IHost Build(Action<HostApplicationBuilder> configure, params (string Key, string Value)[] settings)
    {
        HostApplicationBuilder builder = Host.CreateEmptyApplicationBuilder(new HostApplicationBuilderSettings());
        builder.Configuration.AddInMemoryCollection(settings.Select(setting => KeyValuePair.Create(setting.Key, (string?)setting.Value)));
        configure(builder);

        // A busy machine delays threads for seconds.
        builder.Services.PostConfigureAll<NeuronReaderOptions>(
            static options => (options.SilenceTimeout, options.StopTimeout) = (Limits.Unexpected, Limits.Unexpected));
        return builder.Build();
    }

    private static string Text(int port) => port.ToString(provider: null);

    [SuppressMessage("Performance", "CA1812", Justification = "Made by the host.")]
    private sealed class Consumer(NeuronReader reader) : BackgroundService
    {
        // Here and not in ExecuteAsync, which runs beside the start of the host since .NET 10.
        private readonly FrameQueue _queue = reader.OpenQueue();

        public ConcurrentQueue<uint?> Frames { get; } = [];

        protected override async Task ExecuteAsync(CancellationToken stoppingToken)
        {
            while (!reader.Completion.IsCompleted)
            {
                _queue.Pump<MotionFrame>(frame => Frames.Enqueue(frame.FrameIndex));
                await Task.Delay(1, CancellationToken.None);
            }
        }
    }

    private sealed class LogLines : ILoggerProvider
    {
        public ConcurrentQueue<string> Lines { get; } = [];

        public ILogger CreateLogger(string categoryName) => new Logger(categoryName, Lines);

        public void Dispose()
        {
        }

        private sealed class Logger(string category, ConcurrentQueue<string> lines) : ILogger
        {
            public IDisposable? BeginScope<TState>(TState state)
                where TState : notnull => null;

            public bool IsEnabled(LogLevel logLevel) => true;

            public void Log<TState>(LogLevel logLevel, EventId eventId, TState state, Exception? exception, Func<TState, Exception?, string> formatter) =>
                lines.Enqueue($"{category} {eventId.Id} {formatter(state, exception)}");
        }
    }
}
