using System.Collections.Concurrent;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Hosting;
using Microsoft.AspNetCore.Http;
using Microsoft.Extensions.Logging;

namespace NeuronMocap.Hosting.Tests.Samples;

/// <summary>A collector on a free loopback port that keeps what it receives: OTLP as protobuf over HTTP.</summary>
internal sealed class OtlpReceiver : IAsyncDisposable
{
    private readonly WebApplication _server;

    private OtlpReceiver(WebApplication server) => _server = server;

    public string Url => _server.Urls.Single();

    public ConcurrentQueue<OtlpMetric> Metrics { get; } = [];

    /// <summary>The raw logs, for text searches.</summary>
    public ConcurrentQueue<byte[]> Logs { get; } = [];

    /// <summary>The raw spans, for text searches.</summary>
    public ConcurrentQueue<byte[]> Traces { get; } = [];

    public static async Task<OtlpReceiver> StartAsync()
    {
        WebApplicationBuilder builder = WebApplication.CreateSlimBuilder();
        builder.Logging.ClearProviders();
        builder.WebHost.UseUrls("http://127.0.0.1:0");
        var receiver = new OtlpReceiver(builder.Build());
        receiver._server.MapPost("/v1/metrics", async (HttpRequest request) =>
        {
            foreach (OtlpMetric metric in OtlpMetric.ReadAll(await ReadAsync(request)))
                receiver.Metrics.Enqueue(metric);
        });
        receiver._server.MapPost("/v1/logs", async (HttpRequest request) => receiver.Logs.Enqueue(await ReadAsync(request)));
        receiver._server.MapPost("/v1/traces", async (HttpRequest request) => receiver.Traces.Enqueue(await ReadAsync(request)));
        await receiver._server.StartAsync();
        return receiver;
    }

    public ValueTask DisposeAsync() => _server.DisposeAsync();

    private static async Task<byte[]> ReadAsync(HttpRequest request)
    {
        using var body = new MemoryStream();
        await request.Body.CopyToAsync(body);
        return body.ToArray();
    }
}
