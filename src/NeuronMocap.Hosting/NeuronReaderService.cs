using Microsoft.Extensions.Hosting;

namespace NeuronMocap.Hosting;

// Starts the reader last and stops it first. Hosted services that consume frames then miss no frame, and their loops end without cancellation.
internal sealed class NeuronReaderService(NeuronReader reader) : IHostedLifecycleService
{
    public Task StartingAsync(CancellationToken cancellationToken) => Task.CompletedTask;

    public Task StartAsync(CancellationToken cancellationToken) => Task.CompletedTask;

    // Does not wait for a connection. The server may start later, and the reader reports why it has no connection.
    public Task StartedAsync(CancellationToken cancellationToken)
    {
        reader.Start();
        return Task.CompletedTask;
    }

    // The container disposes the reader and its metrics, after the services that export the metrics for the last time.
    public async Task StoppingAsync(CancellationToken cancellationToken)
    {
        try
        {
            await reader.StopAsync(keepsMetrics: true).AsTask().WaitAsync(cancellationToken).ConfigureAwait(false);
        }
        catch (OperationCanceledException) when (cancellationToken.IsCancellationRequested)
        {
            // The host's time-out has passed. The socket of the reader is closed, so the reader ends within 2 s.
        }
    }

    public Task StopAsync(CancellationToken cancellationToken) => Task.CompletedTask;

    public Task StoppedAsync(CancellationToken cancellationToken) => Task.CompletedTask;
}
