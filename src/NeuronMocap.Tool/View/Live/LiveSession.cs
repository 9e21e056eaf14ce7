using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Routing;
using NeuronMocap.AspNetCore;
using NeuronMocap.Tool.View.Control;
using NeuronMocap.Tool.View.Performers;
using NeuronMocap.Tool.View.Web;

namespace NeuronMocap.Tool.View.Live;

/// <summary>The live stream for all pages: /motion, and the messages about performers and the state.</summary>
/// <remarks>While no page listens, only the reader works, and its queue for /motion is emptied.</remarks>
internal sealed class LiveSession : IViewPart
{
    private static readonly TimeSpan Period = TimeSpan.FromSeconds(1);

    private readonly Lock _lock = new();
    private readonly NeuronReader _reader;
    private readonly ControlHub _hub;
    private readonly WebSocketBroadcaster _broadcaster;
    private readonly LiveStatus _status;
    private readonly Timer _timer;
    private IDisposable? _subscription;
    private bool _isDisposed;

    /// <summary>Creates a session for a reader that has not started yet.</summary>
    /// <param name="reader">The reader. Its owner starts it, and disposes it after this session.</param>
    /// <param name="source">The source, for the pages.</param>
    /// <param name="hub">The pages.</param>
    public LiveSession(NeuronReader reader, string source, ControlHub hub)
    {
        (_reader, _hub) = (reader, hub);
        var numbers = new PerformerNumbers();
        Poses = new PoseMessages(numbers);
        Motion = new LiveMotion(reader);
        Performers = new LivePerformers(reader, numbers, hub.Send);

        // The server has checked the origin and the token.
        _broadcaster = new WebSocketBroadcaster(reader, new WebSocketBroadcasterOptions { AllowedOrigins = ["*"] }, Poses.Encode);
        _status = new LiveStatus(reader, source, Performers, _broadcaster, Poses.Latency);
        _timer = new Timer(_ => Tick());
        hub.ClientsChanged += Reconsider;
        reader.StatusChanged += OnStatus;
    }

    /// <summary>Called once a second while a page listens, on a pool thread.</summary>
    public event Action? Ticked;

    /// <summary>The performers.</summary>
    public LivePerformers Performers { get; }

    /// <summary>The frames for whoever needs them.</summary>
    public LiveMotion Motion { get; }

    /// <summary>The poses for /motion.</summary>
    public PoseMessages Poses { get; }

    /// <summary>Number of pages that show motion.</summary>
    public int MotionClients => _broadcaster.GetStatistics().Clients;

    /// <summary>The performers for the first message to a page.</summary>
    public IReadOnlyList<PerformerJson> Introduce()
    {
        Performers.Update();
        return [.. Performers.List.Select(static performer => performer.ToJson())];
    }

    /// <summary>Makes the messages after hello for a new page.</summary>
    public IEnumerable<object> Greet() => [.. Performers.Greet(), Describe()];

    /// <summary>Describes the state of the stream.</summary>
    public StatusMessage Describe() => _status.Describe();

    public void Map(IEndpointRouteBuilder endpoints) => endpoints.MapNeuronWebSocket("/motion", _broadcaster);

    public async ValueTask DisposeAsync()
    {
        _hub.ClientsChanged -= Reconsider;
        _reader.StatusChanged -= OnStatus;
        lock (_lock)
        {
            _isDisposed = true;
            _subscription?.Dispose();
            _subscription = null;
        }

        await _timer.DisposeAsync();
        Motion.Dispose();
        await _broadcaster.DisposeAsync();
    }

    // Works only while somebody listens.
    private void Reconsider()
    {
        lock (_lock)
        {
            bool isNeeded = !_isDisposed && _hub.Clients > 0;
            if (isNeeded == _subscription is not null)
                return;

            _subscription?.Dispose();
            _subscription = isNeeded ? Motion.Subscribe(Performers.Take) : null;
            if (!_isDisposed)
                _timer.Change(isNeeded ? Period : Timeout.InfiniteTimeSpan, isNeeded ? Period : Timeout.InfiniteTimeSpan);
        }
    }

    private void Tick()
    {
        Performers.Update();
        _status.Update();
        _hub.Send(_status.Describe());
        Ticked?.Invoke();
    }

    private void OnStatus(ConnectionStatus status)
    {
        if (_hub.Clients > 0)
            _hub.Send(_status.Describe());
    }
}
