// A service that receives a stream. It exports the reader's metrics and logs, and a trace of its connections, with OpenTelemetry.
//
//   dotnet run --project samples/Telemetry                          a simulator inside this program; everything goes to the console
//   dotnet run --project samples/Telemetry -- --NeuronReader:Host=192.168.1.20 --Collector=http://127.0.0.1:4318
//
// All settings come from the configuration: appsettings.json, environment variables such as NeuronReader__Host, or the command line as above.
// NeuronReader:… are the options of the reader. Collector is the destination of OTLP over HTTP. Seconds ends the service after that time; Ctrl+C ends
// it at any time.
//
// In your own project: dotnet add package NeuronMocap.Hosting.
// Exit code: 0 ended as requested, 1 no frame arrived or the collector accepted nothing, 2 wrong settings.
using System.Diagnostics;
using System.Globalization;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Hosting;
using Microsoft.Extensions.Options;
using NeuronMocap;
using NeuronMocap.Server;
using OpenTelemetry;
using OpenTelemetry.Exporter;
using OpenTelemetry.Logs;
using OpenTelemetry.Metrics;
using OpenTelemetry.Resources;
using OpenTelemetry.Trace;

HostApplicationBuilder builder = Host.CreateApplicationBuilder(new HostApplicationBuilderSettings { Args = args, ContentRootPath = AppContext.BaseDirectory });
bool hasServer = Array.Exists(["Host", "Port", "Transport"], key => builder.Configuration[$"NeuronReader:{key}"] is not null);
using Broadcaster? demo = hasServer ? null : Broadcaster.StartDemo();

// This call reads the options from the section NeuronReader, connects the host's logs, and starts and stops the reader with the host.
builder.Services.AddNeuronReader(options =>
{
    if (demo?.LocalEndPoint is { } server)
        (options.Host, options.Port) = (server.Address.ToString(), server.Port);
});
builder.Services.AddHostedService<ConnectionTrace>();

OpenTelemetryBuilder telemetry = builder.Services.AddOpenTelemetry()
    .ConfigureResource(resource => resource.AddService("neuron-telemetry"))
    .WithMetrics(metrics => metrics.AddMeter("NeuronMocap"))
    .WithTracing(traces => traces.AddSource(ConnectionTrace.SourceName))
    .WithLogging(configureBuilder: null, logs => logs.IncludeFormattedMessage = true);
string? collector = builder.Configuration["Collector"];
if (collector is null)
    telemetry.WithMetrics(metrics => metrics.AddConsoleExporter()).WithTracing(traces => traces.AddConsoleExporter()); // the host shows the logs
else if (Uri.TryCreate(collector, UriKind.Absolute, out Uri? url))
    telemetry.UseOtlpExporter(OtlpExportProtocol.HttpProtobuf, url);
else
    return Fail(2, $"Collector is '{collector}'; it must be an address such as http://127.0.0.1:4318.");

double seconds = 0;
string? limit = builder.Configuration["Seconds"];
if (limit is not null && !(double.TryParse(limit, NumberStyles.Float, CultureInfo.InvariantCulture, out seconds) && seconds is > 0 and < 1e6))
    return Fail(2, $"Seconds is '{limit}'; it must be a number of seconds.");

try
{
    using IHost host = builder.Build();
    var reader = host.Services.GetRequiredService<NeuronReader>();
    var meters = host.Services.GetRequiredService<MeterProvider>();
    using var endSource = new CancellationTokenSource();
    if (limit is not null)
        endSource.CancelAfter(TimeSpan.FromSeconds(seconds));

    await host.StartAsync();
    await host.WaitForShutdownAsync(endSource.Token);
    if (reader.GetStatistics().Frames == 0)
        return Fail(1, "No frame arrived; the log above says why.");

    // The reader has stopped, but its last metrics exist until the host is disposed.
    return meters.ForceFlush(timeoutMilliseconds: 5000) ? 0 : Fail(1, $"The collector at {collector} took nothing. Check the address, and that it takes OTLP over HTTP.");
}
catch (OptionsValidationException exception)
{
    return Fail(2, string.Join(Environment.NewLine, exception.Failures));
}

static int Fail(int code, string message)
{
    Console.Error.WriteLine(message);
    return code;
}

/// <summary>Creates a span for each connection, with an event for each change of its state.</summary>
internal sealed class ConnectionTrace(NeuronReader reader) : IHostedService
{
    public const string SourceName = "NeuronMocap.Samples.Telemetry";

    private static readonly ActivitySource Source = new(SourceName);

    private Activity? _connection;

    public Task StartAsync(CancellationToken cancellationToken)
    {
        reader.StatusChanged += OnStatusChanged;
        return Task.CompletedTask;
    }

    public Task StopAsync(CancellationToken cancellationToken) => Task.CompletedTask;

    private void OnStatusChanged(ConnectionStatus status)
    {
        if (status.State == ConnectionState.Connected)
            _connection = Source.StartActivity("connection", ActivityKind.Client)?.SetTag("server.address", status.RemoteEndPoint?.ToString());

        _connection?.AddEvent(new ActivityEvent(status.Message));
        if (status.State is not (ConnectionState.Waiting or ConnectionState.Stopped))
            return;

        _connection?.SetStatus(status.Reason == ConnectionReason.Requested ? ActivityStatusCode.Ok : ActivityStatusCode.Error, status.Message);
        _connection?.Dispose();
        _connection = null;
    }
}
