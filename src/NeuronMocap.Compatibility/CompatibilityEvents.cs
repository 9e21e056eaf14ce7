using System.Diagnostics;

namespace NeuronMocap.Compatibility;

/// <summary>
/// What became of exceptions that registered callbacks threw. They end neither the connection nor the process; other callbacks go on.
/// </summary>
public static class CompatibilityEvents
{
    private static readonly object Lock = new();
    private static readonly TimeSpan Pause = TimeSpan.FromSeconds(10);
    private static readonly Stopwatch SinceLine = new();

    /// <summary>
    /// Called with every exception that a callback threw, on the thread that called the callback. Exceptions of this event's own handlers
    /// are ignored. While it has no handler, exceptions are written to the standard error stream, at most one every 10 s.
    /// </summary>
    public static event Action<Exception>? CallbackFailed;

    internal static void Report(Exception exception)
    {
        try
        {
            if (CallbackFailed is { } handler)
                handler(exception);
            else if (IsLineDue())
                Console.Error.WriteLine($"NeuronMocap: a callback of the application threw: {exception}");
        }
        catch (Exception)
        {
            // Neither a handler of failures nor the text of an exception may bring the receive thread down.
        }
    }

    private static bool IsLineDue()
    {
        lock (Lock)
        {
            if (SinceLine.IsRunning && SinceLine.Elapsed < Pause)
                return false;

            SinceLine.Restart();
            return true;
        }
    }
}
