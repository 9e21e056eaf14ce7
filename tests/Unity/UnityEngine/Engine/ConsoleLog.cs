namespace UnityEngine.StandIn;

/// <summary>All log entries, from any thread.</summary>
internal static class ConsoleLog
{
    private static readonly List<LogEntry> _entries = [];

    public static IReadOnlyList<LogEntry> Entries
    {
        get
        {
            lock (_entries)
                return _entries.ToArray();
        }
    }

    /// <summary>Warnings and errors that no test expects.</summary>
    public static IEnumerable<LogEntry> Problems => Entries.Where(static entry => entry.Type is not LogType.Log);

    public static void Add(LogType type, object? message, Object? context)
    {
        var entry = new LogEntry(type, message?.ToString() ?? "Null", context, message as Exception);
        lock (_entries)
            _entries.Add(entry);

        Application.RaiseLog(entry);
    }

    public static void Remove(LogEntry entry)
    {
        lock (_entries)
            _entries.Remove(entry);
    }

    public static void Clear()
    {
        lock (_entries)
            _entries.Clear();
    }
}

internal sealed class LogEntry(LogType type, string message, Object? context, Exception? exception)
{
    public LogType Type { get; } = type;

    public string Message { get; } = message;

    public Object? Context { get; } = context;

    public Exception? Exception { get; } = exception;

    public override string ToString() => $"{Type}: {Message}";
}
