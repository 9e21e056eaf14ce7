using System.Net;

namespace NeuronMocap.Transport;

internal static class HostResolver
{
    // Gives up on a name that takes longer than the connect timeout, because no runtime can interrupt the system's resolver. Throws SocketException,
    // ArgumentException for names that no computer can have, and TimeoutException, which also means a cancelled wait.
    public static async Task<IPAddress[]> ResolveAsync(LinkOptions options, CancellationToken cancellationToken)
    {
        if (IPAddress.TryParse(options.Host, out IPAddress? address))
            return [address];

        Task<IPAddress[]> resolving = options.Resolve(options.Host);
        using var limitSource = CancellationTokenSource.CreateLinkedTokenSource(cancellationToken);
        Task first = await Task.WhenAny(resolving, CancellableDelay.WaitAsync(options.ConnectTimeout, limitSource.Token)).ConfigureAwait(false);
        limitSource.Cancel();
        if (first == resolving)
            return await resolving.ConfigureAwait(false);

        _ = resolving.ContinueWith(static task => _ = task.Exception, TaskContinuationOptions.OnlyOnFaulted);
        throw new TimeoutException();
    }
}
