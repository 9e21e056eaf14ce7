using Microsoft.Extensions.Configuration;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Hosting;
using Microsoft.Extensions.Logging;
using NeuronMocap.Server;
using OpenTelemetry;
using OpenTelemetry.Exporter;
using OpenTelemetry.Logs;
using OpenTelemetry.Metrics;
using OpenTelemetry.Resources;

namespace NeuronMocap.TelemetryExport;

/// <summary>What the command line asks for.</summary>
internal sealed record TelemetryOptions(string? Host, string? Port, bool Demo, Uri Otlp, TimeSpan Interval, TimeSpan? Duration);

/// <summary>The host, from its start to its end.</summary>
internal sealed class TelemetryRun(TelemetryOptions options)
{
    private const string ServiceName = "neuron-telemetry";
    private const int FlushMilliseconds = 5000;

    /// <summary>Runs until the time is over or a signal comes.</summary>
    /// <returns>What went wrong, or null.</returns>
    public async Task<string?> RunAsync()
    {
        HostApplicationBuilder builder = Host.CreateApplicationBuilder(new HostApplicationBuilderSettings { ContentRootPath = AppContext.BaseDirectory });
        using Broadcaster? demo = CreateDemo(builder.Configuration);
        Configure(builder.Configuration, demo);

        // The section NeuronReader, the host's logs, started and stopped with the host: all of it is this line.
        builder.Services.AddNeuronReader();
        builder.Logging.AddOpenTelemetry(logs =>
        {
            logs.IncludeFormattedMessage = true;
            logs.SetResourceBuilder(ResourceBuilder.CreateDefault().AddService(ServiceName));
            logs.AddOtlpExporter(exporter => Export(exporter, "v1/logs"));
        });

        using IHost host = builder.Build();
        using MeterProvider meters = CreateMeters();
        var reader = host.Services.GetRequiredService<NeuronReader>();
        var lifetime = host.Services.GetRequiredService<IHostApplicationLifetime>();
        bool exported = false;

        // While the reader still stands: one that was stopped reports no more.
        using CancellationTokenRegistration flush = lifetime.ApplicationStopping.Register(() => exported = meters.ForceFlush(FlushMilliseconds));
        using var end = new CancellationTokenSource();
        await host.StartAsync();
        using CancellationTokenRegistration stop = end.Token.Register(lifetime.StopApplication);
        if (options.Duration is { } duration)
            end.CancelAfter(duration);

        await host.WaitForShutdownAsync();
        if (reader.GetStatistics() is { MotionFrames: 0, CalculationFrames: 0 })
            return "No frame arrived; the log above says why.";

        return exported ? null : $"The collector at {options.Otlp} took nothing. Check the address, and that it takes OTLP over HTTP.";
    }

    private MeterProvider CreateMeters() => Sdk.CreateMeterProviderBuilder()
        .ConfigureResource(resource => resource.AddService(ServiceName))
        .AddMeter("NeuronMocap")
        .AddOtlpExporter((exporter, reader) =>
        {
            Export(exporter, "v1/metrics");
            reader.PeriodicExportingMetricReaderOptions.ExportIntervalMilliseconds = (int)options.Interval.TotalMilliseconds;
        })
        .Build();

    private void Export(OtlpExporterOptions exporter, string path)
    {
        exporter.Protocol = OtlpExportProtocol.HttpProtobuf;
        exporter.Endpoint = new Uri(options.Otlp, path);
        exporter.TimeoutMilliseconds = FlushMilliseconds / 2;
    }

    private void Configure(ConfigurationManager configuration, Broadcaster? demo)
    {
        Dictionary<string, string?> settings = new(StringComparer.Ordinal);
        if (demo?.LocalEndPoint is { } address)
        {
            settings["NeuronReader:Host"] = address.Address.ToString();
            settings["NeuronReader:Port"] = address.Port.ToString(provider: null);
            settings["NeuronReader:Transport"] = "Tcp";
        }

        if (options.Host is { } host)
            settings["NeuronReader:Host"] = host;
        if (options.Port is { } port)
            settings["NeuronReader:Port"] = port;

        configuration.AddInMemoryCollection(settings);
    }

    private Broadcaster? CreateDemo(ConfigurationManager configuration)
    {
        IConfigurationSection reader = configuration.GetSection("NeuronReader");
        bool isConfigured = options.Host is not null || options.Port is not null || reader["Host"] is not null || reader["Port"] is not null;
        if (isConfigured && !options.Demo)
            return null;

        var demo = new Broadcaster(new BroadcasterOptions { Sources = [new SyntheticActor(60)], AvatarNames = ["Demo"], Port = 0, WaitForClient = true });
        demo.Start();
        return demo;
    }
}
