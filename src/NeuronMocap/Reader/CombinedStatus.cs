using NeuronMocap.Transport;

namespace NeuronMocap.Reader;

// Combines the statuses of two connections. The status of the first connection is decisive. The calculation port adds a sentence, and a reason if the
// first connection has none. The statuses of each connection arrive in order, on any thread.
internal sealed class CombinedStatus(Action<ConnectionStatus> changed, int calculationPort)
{
    private readonly StatusPublisher _combined = new(changed);
    private ConnectionStatus _first = new(ConnectionState.Created, ConnectionReason.None, "Not started.");
    private ConnectionStatus _calculation = new(ConnectionState.Created, ConnectionReason.None, "Not started.");

    public ConnectionStatus Current => _combined.Current;

    public void OnFirst(ConnectionStatus status) => _combined.TrySet(
        _ => true,
        _ =>
        {
            _first = status;
            return Join();
        });

    public void OnCalculation(ConnectionStatus status) => _combined.TrySet(
        published =>
        {
            // The reader is stopping; its first connection reports that.
            if (status is { State: ConnectionState.Stopped, Reason: ConnectionReason.Requested })
                return false;

            // The next attempt adds nothing to the failure of the last one.
            if (status.State != ConnectionState.Connecting || _calculation.State is ConnectionState.Created)
                _calculation = status;

            ConnectionStatus joint = Join();
            return published.State != ConnectionState.Created && (joint.Reason != published.Reason || !string.Equals(joint.Message, published.Message, StringComparison.Ordinal));
        },
        _ => Join() with { Timestamp = status.Timestamp });

    private ConnectionStatus Join()
    {
        if (_first.State is ConnectionState.Created or ConnectionState.Stopped)
            return _first;

        bool isMissing = _calculation.State is ConnectionState.Waiting or ConnectionState.Silent or ConnectionState.Stopped;
        return _first with
        {
            Reason = isMissing && _first.IsConnected && _first.Reason == ConnectionReason.None ? ConnectionReason.CalculationUnavailable : _first.Reason,
            Message = $"{_first.Message} Calculation port {calculationPort}: {Describe()}",
        };
    }

    private string Describe() => (_calculation.State, _calculation.Reason) switch
    {
        (ConnectionState.Created or ConnectionState.Connecting, _) => "connecting.",
        (ConnectionState.Connected, _) => "connected; waiting for frames.",
        (ConnectionState.Receiving, ConnectionReason.None) => "receiving.",
        (ConnectionState.Waiting or ConnectionState.Stopped, ConnectionReason.Refused) =>
            "connection refused. Switch on calculation data in Axis Neuron's broadcasting settings, and check that its port is the same.",
        (ConnectionState.Waiting or ConnectionState.Stopped, ConnectionReason.PortInUse) => "in use by another program.",
        _ => _calculation.Message,
    };
}
