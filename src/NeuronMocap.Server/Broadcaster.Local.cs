using NeuronMocap.Server.Clients;

namespace NeuronMocap.Server;

/// <content>Recipients in the same process, and those that another server accepted.</content>
public sealed partial class Broadcaster
{
    /// <summary>Creates a source from which readers in this process receive the broadcast, without a port or a connection.</summary>
    /// <remarks>
    /// Set it as <see cref="NeuronReaderOptions.Source"/>. The reader gets what a TCP client of <see cref="BroadcasterOptions.Port"/> gets, except replies
    /// to commands: they need a connection. The broadcaster lists it in <see cref="GetClients"/>, without an address. A reader that opens the source
    /// before the start, or after the end, tries again as after a refused connection.
    /// </remarks>
    /// <param name="name">The name in the reader's status messages, metrics and logs.</param>
    /// <returns>A source for any number of readers, also at the same time.</returns>
    /// <exception cref="ArgumentException">The name is empty.</exception>
    public ByteSource CreateLocalSource(string name = "the broadcaster")
    {
        if (string.IsNullOrWhiteSpace(name))
            throw new ArgumentException("The name must not be empty.", nameof(name));

        return new LocalSource(name, AcceptLocal);
    }

    private LocalRecipient AcceptLocal()
    {
        lock (_lock)
        {
            CheckRuns();
            BroadcastStream stream = _streams[0];
            var recipient = new LocalRecipient(stream, stream.CreateFeed(isSingle: false), OnRecipientEnded);
            _recipients.Add(recipient);
            OnServed(stream);
            return recipient;
        }
    }

    internal bool HasCalculationStream => _streams.Any(static stream => stream.IsBeside);

    // Serves a connection that another server accepted, like a client of Port or of CalculationPort. The task ends when the client is no longer served. Returns false if there is no
    // place for it. The caller then ends the connection.
    internal bool TryServe(ClientTransport transport, bool isCalculation, out Task served)
    {
        var completion = new TaskCompletionSource<bool>(TaskCreationOptions.RunContinuationsAsynchronously);
        served = completion.Task;
        lock (_lock)
        {
            CheckRuns();
            return TryServe(_streams.First(stream => stream.IsBeside == isCalculation), () => transport, OnEnded);
        }

        void OnEnded(Recipient recipient, Exception? error)
        {
            OnRecipientEnded(recipient, error);
            completion.TrySetResult(true);
        }
    }

    private void CheckRuns()
    {
        if (_hasEnded || !_isStarted)
            throw new NeuronConnectionException(ConnectionReason.Refused, _hasEnded ? "The broadcaster has been stopped." : "The broadcaster has not been started.");
    }
}
