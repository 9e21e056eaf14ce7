using NeuronMocap.Commands;
using NeuronMocap.Compatibility.Callbacks;

namespace NeuronMocap.Compatibility.Sockets;

// A connection or service that receives frames: a reader that never connects again by itself, as scripts do that.
internal abstract class DataSocket : VendorSocket
{
    // The vendor's library gives up after about as long.
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
            // No port has that number, or no computer that name: opening fails.
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
                _delivery.Deliver(Handle, frame);
        };
        _reader.CalculationReceived += frame =>
        {
            if (IsReceiving())
                _delivery.Deliver(Handle, frame);
        };
        _reader.DataCommands.Received += reply =>
        {
            if (IsReceiving())
                _delivery.Deliver(Handle, reply);
        };
    }

    // Null where there can be no connection. Commands are sent in whatever state the reader is; it says false where they cannot be.
    public DataCommands? Commands => _reader?.DataCommands;

    protected IVendorCallbacks Callbacks { get; }

    // The system's number of what went wrong, or null when the reader receives.
    protected int? StartReader()
    {
        if (_reader is null)
            return SystemError.InvalidArgument;

        // Waited for on this thread alone: a busy process may have no other for a while.
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

    // The connection stood, and ended without being closed here. On a thread of the reader, after its last frame.
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

    // Receive thread. The first frame may be here before the opening thread has told that there is a connection.
    private bool IsReceiving()
    {
        WaitUntilOpenReported();
        return !IsClosed;
    }
}
