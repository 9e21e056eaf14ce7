using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Reader;

// The second connection of a reader, to the port of calculation data. It connects, ends and reconnects independently.
internal sealed class CalculationConnection
{
    private readonly StatusPublisher _status;
    private readonly LinkActivity _activity;
    private readonly ConnectionSupervisor _supervisor;
    private readonly CalculationPortReceiver _receiver;

    public CalculationConnection(
        NeuronReaderOptions options, FrameFormat format, ReceivePipeline pipeline, SenderFilter? udpSenders, Func<Link> createLink, Action<ConnectionStatus> changed)
    {
        var recognizer = new StreamRecognizer(format);
        _status = new StatusPublisher(changed);
        _activity = new LinkActivity(_status, options.SilenceTimeout, udpSenders, recognizer.Describe);
        _supervisor = new ConnectionSupervisor(createLink, options.Reconnect, _status, _activity, new Random().NextDouble);
        _receiver = new CalculationPortReceiver(pipeline, recognizer, _activity, pipeline.Tap.AddCalculation());
    }

    public ConnectionStatus Status => _status.Current;

    // Completes when the reader is stopped or, if reconnecting is off, after the first link.
    public async Task RunAsync(CancellationToken cancellationToken)
    {
        ConnectionStatus last;
        try
        {
            last = await _supervisor.RunAsync(new CalculationOnlyReceiver(_receiver), _receiver, cancellationToken).ConfigureAwait(false);
        }
        catch (Exception exception)
        {
            last = new ConnectionStatus(ConnectionState.Stopped, ConnectionReason.NetworkError, ConnectionMessages.Failed("the port of calculation data", exception));
        }

        _status.Set(last);
    }

    // Timer.
    public void Check(long now) => _activity.Check(now);
}
