using System.Diagnostics;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>
/// Reports exceptions from a server's threads to the handlers. Without a handler, the first one goes to <see cref="Trace"/>. Never throws.
/// </summary>
/// <param name="server">Name of the server in the trace.</param>
internal sealed class FaultReport(string server)
{
    private int _isTraced;

    public event Action<Exception>? Failed;

    public void Report(Exception exception)
    {
        if (Failed is not { } handlers)
        {
            TraceOnce(exception);
            return;
        }

        foreach (Action<Exception> handler in handlers.GetInvocationList().Cast<Action<Exception>>())
        {
            try
            {
                handler(exception);
            }
            catch (Exception ofHandler)
            {
                TraceOnce(ofHandler);
            }
        }
    }

    // A client that repeats a failing request must not fill a log.
    private void TraceOnce(Exception exception)
    {
        if (Interlocked.Exchange(ref _isTraced, 1) != 0)
            return;

        try
        {
            Trace.TraceError("{0}: a thread of the server threw an exception. The server continues. {1}", server, exception);
        }
        catch (Exception)
        {
            // Trace listeners are user code, and no handler is left to report to.
        }
    }
}
