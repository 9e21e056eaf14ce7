using NeuronMocap.Commands;
using NeuronMocap.Compatibility.Callbacks;

namespace NeuronMocap.Compatibility.Sockets;

// A connection or service that receives frames. Its reader does not reconnect, because scripts reconnect themselves.
internal abstract class DataSocket : VendorSocket
{
    // The vendor's library gives up after about the same time.
    private static readonly TimeSpan OpenTimeout = TimeSpan.FromSeconds(5);

    private readonly NeuronReader? _reader;
    private readonly PacketDelivery _delivery;
    private volatile bool _wasConnected;

    protected DataSocket(IVendorCallbacks callbacks, NeuronReaderOptions options)
    {
        Callbacks = callbacks;
        _delivery = new PacketDelivery(callbacks, Gate);
        options.Reconnect.Enabled = false;
        options.ConnectTimeout = OpenTimeout;
        try
        {
            _reader = new NeuronReader(options) { StartsOnPool = true };
        }
        catch (ArgumentException)
        {
            // The port number is out of range or the computer name is invalid, so opening fails.
            return;
        }

        _reader.CallbackFailed += exception =>
        {
            if (!_delivery.HasReported(exception))
                CompatibilityEvents.Report(exception);
        };
        _reader.StatusChanged += OnReaderStatus;
        _reader.MotionReceived += frame =>
        {
            if (IsReceiving())
                _delivery.Deliver(Handle, _reader.HandlerThreadNumber, frame);
        };
        _reader.CalculationReceived += frame =>
        {
            if (IsReceiving())
                _delivery.Deliver(Handle, _reader.HandlerThreadNumber, frame);
        };
        _reader.DataCommands.Received += reply =>
        {
            if (IsReceiving())
                _delivery.Deliver(Handle, _reader.HandlerThreadNumber, reply);
        };
    }

    // Null if a connection is impossible. Commands may be called in any state of the reader. They return false if they cannot be sent.
    public DataCommands? Commands => _reader?.DataCommands;

    protected IVendorCallbacks Callbacks { get; }

    // Returns the system's error number, or null when the reader receives.
    protected int? StartReader()
    {
        if (_reader is null)
            return SystemError.InvalidArgument;

        // Waits on this thread alone. A busy process may have no other thread available for a while.
        Task started = _reader.StartAsync();
        bool isOver = Task.WaitAny([started], OpenTimeout) >= 0;
        if (isOver && started.IsCompletedSuccessfully)
            return null;

        _reader.Dispose();
        return SystemError.CodeOf(isOver && started.Exception?.InnerException is NeuronConnectionException failure
            ? failure.Reason
            : ConnectionReason.TimedOut);
    }

    protected override void BeginRelease() => _reader?.Stop();

    protected override void WaitUntilReleased() => _reader?.Dispose();

    // The connection was open, and it ended without being closed here. Runs on a thread of the reader, after its last frame.
    protected abstract void OnEnded(ConnectionReason reason);

    private void OnReaderStatus(ConnectionStatus status)
    {
        _wasConnected |= status.IsConnected;
        if (status.State != ConnectionState.Stopped || !_wasConnected)
            return;

        WaitUntilOpenReported();
        if (IsClosed)
            return;

        SetOver();
        OnEnded(status.Reason);
        _reader!.Dispose();
    }

    // Receive thread. The first frame may arrive before the opening thread has reported the connection.
    private bool IsReceiving()
    {
        WaitUntilOpenReported();
        return !IsClosed;
    }
}
