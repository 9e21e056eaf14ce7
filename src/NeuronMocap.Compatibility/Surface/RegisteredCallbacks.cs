using NeuronMocap;
using NeuronMocap.Compatibility.Callbacks;

namespace NeuronDataReaderWraper;

// Calls the delegates of this namespace.
internal sealed class RegisteredCallbacks : IVendorCallbacks
{
    private readonly CallbackSlot<FrameDataReceived> _frame = new();
    private readonly CallbackSlot<FrameDataReceived> _calculation = new();
    private readonly CallbackSlot<SocketStatusChanged> _status = new();
    private readonly CallbackSlot<CommandDataReceived> _command = new();
    private FrameDataReceived? _calculationHandler;
    private CommandDataReceived? _commandHandler;

    // The struct of this namespace has only this layout.
    public HeaderLayout FrameHeaders => HeaderLayout.New;

    public bool WantsFrames => NeuronDataReader.frameDataReceivedCallback is not null;

    public bool WantsCalculation => _calculationHandler is not null;

    public bool WantsCommands => _commandHandler is not null;

    public void SetFrame(IntPtr customObject, FrameDataReceived? handler) =>
        _frame.Set(ref NeuronDataReader.frameDataReceivedCallback, customObject, handler);

    public void SetCalculation(IntPtr customObject, FrameDataReceived? handler) => _calculation.Set(ref _calculationHandler, customObject, handler);

    public void SetStatus(IntPtr customObject, SocketStatusChanged? handler) =>
        _status.Set(ref NeuronDataReader.socketStatusChangedCallback, customObject, handler);

    public void SetCommand(IntPtr customObject, CommandDataReceived? handler) => _command.Set(ref _commandHandler, customObject, handler);

    public void OnFrame(IntPtr socket, IntPtr header, IntPtr data) =>
        _frame.Get(ref NeuronDataReader.frameDataReceivedCallback, out IntPtr customObject)?.Invoke(customObject, socket, header, data);

    public void OnCalculation(IntPtr socket, IntPtr header, IntPtr data) =>
        _calculation.Get(ref _calculationHandler, out IntPtr customObject)?.Invoke(customObject, socket, header, data);

    public void OnStatus(IntPtr socket, SocketState status, string message) =>
        _status.Get(ref NeuronDataReader.socketStatusChangedCallback, out IntPtr customObject)
            ?.Invoke(customObject, socket, (SocketStatus)status, message);

    public void OnCommand(IntPtr socket, IntPtr header, IntPtr data) =>
        _command.Get(ref _commandHandler, out IntPtr customObject)?.Invoke(customObject, socket, header, data);
}
