using NeuronMocap.Server;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Relay.Destinations;

/// <summary>A network destination. Each has its own broadcaster, and with it its own queue and counters.</summary>
internal sealed class BroadcastOutlet : Outlet
{
    // What clients get at the end, to read what is queued for them.
    private static readonly TimeSpan CloseTimeout = TimeSpan.FromSeconds(2);

    // A second or more of the packets of many avatars.
    private const int QueueCapacity = 1024;

    private readonly Broadcaster _broadcaster;
    private readonly bool _isListening;

    private BroadcastOutlet(Broadcaster broadcaster, string name, bool isListening) => (_broadcaster, Name, _isListening) = (broadcaster, name, isListening);

    public override string Name { get; }

    public override string Announcement => _isListening ? $"Listening on {_broadcaster.LocalEndPoint}" : $"Sending to {Name}";

    public override string Noun => "packet";

    /// <summary>Starts to send.</summary>
    /// <param name="reader">The reader.</param>
    /// <param name="options">Where to listen, or where to send.</param>
    /// <param name="nameOf">Gets the name of the destination from the started broadcaster.</param>
    /// <exception cref="BroadcasterException">The port or the destination is not available.</exception>
    public static BroadcastOutlet Start(NeuronReader reader, BroadcasterOptions options, Func<Broadcaster, string> nameOf)
    {
        options.Reader = reader;
        options.CloseTimeout = CloseTimeout;
        options.QueueCapacity = QueueCapacity;
        var broadcaster = new Broadcaster(options);
        try
        {
            broadcaster.Start();
            return new BroadcastOutlet(broadcaster, nameOf(broadcaster), options.Port is not null);
        }
        catch
        {
            broadcaster.Dispose();
            throw;
        }
    }

    public override OutletFigures GetFigures()
    {
        BroadcasterStatistics statistics = _broadcaster.GetStatistics();
        return new OutletFigures(statistics.FramesSent, statistics.PacketsDropped)
        {
            Clients = _isListening ? statistics.Clients : null,
            Bytes = statistics.BytesSent,
            Failure = _broadcaster.Completion.Exception?.InnerException?.Message,
        };
    }

    // A client that left early, or a computer that is off, is no fault of the relay.
    public override async Task<bool> FinishAsync(StandardStreams streams)
    {
        await Task.WhenAny(_broadcaster.Completion, Task.Delay(2 * CloseTimeout));
        await DisposeAsync();
        return true;
    }

    public override ValueTask DisposeAsync() => _broadcaster.DisposeAsync();
}
