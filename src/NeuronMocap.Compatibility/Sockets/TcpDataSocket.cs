using NeuronMocap.Compatibility.Callbacks;

namespace NeuronMocap.Compatibility.Sockets;

// A TCP connection, and the status callbacks that report its state (protocol.md section 10; the spelling is the same as there).
internal sealed class TcpDataSocket(IVendorCallbacks callbacks, string host, int port)
    : DataSocket(callbacks, new NeuronReaderOptions { Host = host, Port = port })
{
    private const string Stopped = "Service is stoped\n";

    private readonly string _target = FormattableString.Invariant($"{host}:{port}");

    public override bool IsTo(VendorSocket other) => other is TcpDataSocket tcp
        && tcp.Callbacks == Callbacks
        && string.Equals(tcp._target, _target, StringComparison.OrdinalIgnoreCase);

    protected override bool TryOpen()
    {
        Report(SocketState.Starting, $"Connecting to {_target} ...\n");
        if (IsClosed)
            return false;

        int? error = StartReader();
        if (IsClosed)
            return false;

        if (error is int code)
        {
            string message = $"Failed to connect to '{_target}'.";
            LastError.Set(message, code);
            Report(SocketState.Starting, message);
            SetOver();
            Report(SocketState.OffWork, Stopped);
            return false;
        }

        SetOpen();
        Report(SocketState.Running, $"Successfully connected to '{_target}'.");
        return true;
    }

    protected override void OnClosed() => Invoke(SocketState.OffWork, Stopped, isEnd: true);

    protected override void OnEnded(ConnectionReason reason)
    {
        const string message = "Failed to read data.";
        if (reason == ConnectionReason.ClosedByPeer)
            LastError.Set(message);
        else
            LastError.Set(message, SystemError.CodeOf(reason));

        Report(SocketState.Running, message);
        Report(SocketState.Running, "Data thread exited.\n");
    }

    // Events on other threads are not reported once the program has closed the connection.
    private void Report(SocketState status, string message) => Invoke(status, message, isEnd: false);

    private void Invoke(SocketState status, string message, bool isEnd)
    {
        if (!Gate.TryBeginReport(isEnd))
            return;

        if (isEnd)
            SetEndReported();

        try
        {
            Callbacks.OnStatus(Handle, status, message);
        }
        catch (Exception exception)
        {
            CompatibilityEvents.Report(exception);
        }
        finally
        {
            Gate.EndReport();
        }
    }
}
