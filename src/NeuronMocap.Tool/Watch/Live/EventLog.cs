using NeuronMocap.Tool.Output;
using NeuronMocap.Tool.Terminal;
using Spectre.Console;

namespace NeuronMocap.Tool.Watch.Live;

/// <summary>A change of the connection's state, a failed file or the effect of a key, with the number of its consecutive occurrences.</summary>
internal readonly record struct LoggedEvent(DateTime Time, string Text, Color Color, int Count);

/// <summary>The last events. Thread-safe.</summary>
internal sealed class EventLog
{
    private const int Capacity = 100;

    private readonly Lock _lock = new();
    private readonly List<LoggedEvent> _events = [];

    public void Add(DateTime time, ConnectionStatus status)
    {
        // Repeated attempts would displace all other events.
        if (status is { State: ConnectionState.Connecting, Attempt: > 1 })
            return;

        Add(time, status.Describe(), Palette.Of(status.State));
    }

    public void Add(DateTime time, FileFailure failure) => Add(time, failure.Text, Palette.Bad);

    /// <summary>Adds the effect of a key.</summary>
    public void Add(DateTime time, string text) => Add(time, TerminalText.Clean(text), Palette.Middle);

    private void Add(DateTime time, string text, Color color)
    {
        lock (_lock)
        {
            bool repeated = _events.Count > 0 && _events[^1].Color == color && string.Equals(_events[^1].Text, text, StringComparison.Ordinal);
            int count = repeated ? _events[^1].Count + 1 : 1;
            if (repeated || _events.Count == Capacity)
                _events.RemoveAt(repeated ? _events.Count - 1 : 0);

            _events.Add(new LoggedEvent(time, text, color, count));
        }
    }

    /// <summary>Gets the newest events, oldest first.</summary>
    public IReadOnlyList<LoggedEvent> Newest(int count)
    {
        lock (_lock)
            return [.. _events.TakeLast(count)];
    }
}
