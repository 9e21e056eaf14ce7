using System.Diagnostics;

namespace NeuronMocap.Compatibility;

/// <summary>Reports exceptions that registered callbacks throw.</summary>
/// <remarks>Such an exception ends neither the connection nor the process. Other callbacks continue.</remarks>
public static class CompatibilityEvents
{
    private static readonly object Lock = new();
    private static readonly TimeSpan Pause = TimeSpan.FromSeconds(10);
    private static readonly Stopwatch SinceLine = new();

    /// <summary>Occurs when a callback throws an exception. The event is raised on the thread that called the callback.</summary>
    /// <remarks>
    /// Exceptions of this event's own handlers are ignored. Without a handler, exceptions are written to the standard error stream, at most one every
    /// 10 s.
    /// </remarks>
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
            // Neither a handler of this event nor the text of an exception may end the receive thread.
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
