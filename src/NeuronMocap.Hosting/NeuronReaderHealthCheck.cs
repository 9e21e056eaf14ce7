using Microsoft.Extensions.Diagnostics.HealthChecks;

namespace NeuronMocap.Hosting;

// Healthy while frames arrive, degraded while a connection delivers no frames, unhealthy without a connection.
internal sealed class NeuronReaderHealthCheck(NeuronReader reader) : IHealthCheck
{
    public Task<HealthCheckResult> CheckHealthAsync(HealthCheckContext context, CancellationToken cancellationToken = default)
    {
        ConnectionStatus status = reader.Status;
        HealthStatus health = status.State switch
        {
            ConnectionState.Receiving => HealthStatus.Healthy,
            ConnectionState.Connected or ConnectionState.Silent => HealthStatus.Degraded,
            _ => context.Registration.FailureStatus,
        };
        Dictionary<string, object> data = new(StringComparer.Ordinal)
        {
            ["reader"] = reader.Name,
            ["state"] = status.State.ToString(),
            ["reason"] = status.Reason.ToString(),
        };
        return Task.FromResult(new HealthCheckResult(health, status.Message, exception: null, data));
    }
}
