using System.Diagnostics;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>Tells of what was thrown on a server's threads: to the handlers, or where there is none, once, to <see cref="Trace"/>. Never throws.</summary>
/// <param name="server">What the trace calls the server.</param>
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

    // A client that repeats what fails shall not fill a log.
    private void TraceOnce(Exception exception)
    {
        if (Interlocked.Exchange(ref _isTraced, 1) != 0)
            return;

        try
        {
            Trace.TraceError("{0}: an exception was thrown on a thread of the server, which goes on. {1}", server, exception);
        }
        catch (Exception)
        {
            // Trace listeners are the user's, too; there is nobody left to tell.
        }
    }
}
