using System.Collections.Concurrent;
using System.Net;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Hosting;
using Microsoft.AspNetCore.Server.Kestrel.Core;
using Microsoft.Extensions.Logging;

namespace NeuronMocap.AspNetCore.Tests.Infrastructure;

/// <summary>A web application with one address, on this computer.</summary>
internal sealed class WebServer : IAsyncDisposable
{
    private readonly WebApplication _application;

    private WebServer(WebApplication application, LogLines log)
    {
        (_application, Log) = (application, log.Lines);
        Port = new Uri(_application.Urls.Single()).Port;
    }

    public int Port { get; }

    public ConcurrentQueue<string> Log { get; }

    /// <summary>Starts an application.</summary>
    /// <param name="listen">Configures the address; null for HTTP.</param>
    /// <param name="map">Adds endpoints.</param>
    /// <param name="port">The port; 0 for any.</param>
    public static async Task<WebServer> StartAsync(Action<ListenOptions>? listen = null, Action<WebApplication>? map = null, int port = 0)
    {
        WebApplicationBuilder builder = WebApplication.CreateSlimBuilder();
        var log = new LogLines();
        builder.Logging.ClearProviders().AddProvider(log);
        builder.WebHost.ConfigureKestrel(options => options.Listen(IPAddress.Loopback, port, listen ?? (static _ => { })));
        WebApplication application = builder.Build();
        map?.Invoke(application);
        await application.StartAsync(TestContext.Current.CancellationToken).Soon();
        return new WebServer(application, log);
    }

    public Task StopAsync() => _application.StopAsync(TestContext.Current.CancellationToken).Soon();

    public ValueTask DisposeAsync() => _application.DisposeAsync();

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

            public bool IsEnabled(LogLevel logLevel) => logLevel >= LogLevel.Warning;

            public void Log<TState>(LogLevel logLevel, EventId eventId, TState state, Exception? exception, Func<TState, Exception?, string> formatter) =>
                lines.Enqueue($"{logLevel} {category}: {formatter(state, exception)}");
        }
    }
}
