using NeuronMocap.Transport;

namespace NeuronMocap.Monitor.Terminal;

/// <summary>A change of the connection's state, and how often it came in a row.</summary>
internal readonly record struct LoggedEvent(DateTime Time, ConnectionStatus Status, int Count);

/// <summary>The last changes of the connection's state. Any thread.</summary>
internal sealed class EventLog
{
    private const int Capacity = 100;

    private readonly Lock _lock = new();
    private readonly List<LoggedEvent> _events = [];

    public void Add(DateTime time, ConnectionStatus status)
    {
        // One attempt after the other would push out everything else.
        if (status is { State: ConnectionState.Connecting, Attempt: > 1 })
            return;

        lock (_lock)
        {
            bool repeated = _events.Count > 0 && _events[^1].Status.State == status.State
                && string.Equals(_events[^1].Status.Message, status.Message, StringComparison.Ordinal);
            int count = repeated ? _events[^1].Count + 1 : 1;
            if (repeated || _events.Count == Capacity)
                _events.RemoveAt(repeated ? _events.Count - 1 : 0);

            _events.Add(new LoggedEvent(time, status, count));
        }
    }

    /// <summary>The newest events, oldest first.</summary>
    public IReadOnlyList<LoggedEvent> Newest(int count)
    {
        lock (_lock)
            return [.. _events.TakeLast(count)];
    }
}
