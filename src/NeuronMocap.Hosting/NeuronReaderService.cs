using Microsoft.Extensions.Hosting;

namespace NeuronMocap.Hosting;

// Starts the reader last and stops it first: hosted services that consume frames miss none, and their loops end by themselves.
internal sealed class NeuronReaderService(NeuronReader reader) : IHostedLifecycleService
{
    public Task StartingAsync(CancellationToken cancellationToken) => Task.CompletedTask;

    public Task StartAsync(CancellationToken cancellationToken) => Task.CompletedTask;

    // Does not wait for a connection: the server may come later, and the reader says why there is none.
    public Task StartedAsync(CancellationToken cancellationToken)
    {
        reader.Start();
        return Task.CompletedTask;
    }

    // The container disposes of the reader, and with it of its metrics, after those who export them for the last time.
    public async Task StoppingAsync(CancellationToken cancellationToken)
    {
        try
        {
            await reader.StopAsync(keepsMetrics: true).AsTask().WaitAsync(cancellationToken).ConfigureAwait(false);
        }
        catch (OperationCanceledException) when (cancellationToken.IsCancellationRequested)
        {
            // The host's time is up; the reader, whose socket is closed, needs no more than 2 s by itself.
        }
    }

    public Task StopAsync(CancellationToken cancellationToken) => Task.CompletedTask;

    public Task StoppedAsync(CancellationToken cancellationToken) => Task.CompletedTask;
}
