using Microsoft.Extensions.Diagnostics.HealthChecks;
using NeuronMocap;
using NeuronMocap.Hosting;

namespace Microsoft.Extensions.DependencyInjection;

/// <summary>Extension methods that add readers to the host's health checks.</summary>
public static class NeuronReaderHealthCheckExtensions
{
    /// <summary>
    /// Adds a check of a reader: healthy while frames arrive, degraded while it is connected without frames, unhealthy without a connection.
    /// </summary>
    /// <remarks>The description is the message of <see cref="NeuronReader.Status"/>, which names the setting to check.</remarks>
    /// <param name="checks">The host's checks, from <c>AddHealthChecks</c>.</param>
    /// <param name="name">Name of the reader as it was added. Null, the default, selects the reader without a name.</param>
    /// <returns>The checks.</returns>
    public static IHealthChecksBuilder AddNeuronReader(this IHealthChecksBuilder checks, string? name = null)
    {
        ArgumentNullException.ThrowIfNull(checks);
        return checks.Add(new HealthCheckRegistration(
            name is null ? "neuron-reader" : $"neuron-reader-{name}",
            provider => new NeuronReaderHealthCheck(
                name is null ? provider.GetRequiredService<NeuronReader>() : provider.GetRequiredKeyedService<NeuronReader>(name)),
            failureStatus: null,
            tags: null));
    }
}
