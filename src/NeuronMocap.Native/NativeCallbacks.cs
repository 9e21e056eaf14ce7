using System.Text;
using NeuronMocap.Compatibility.Callbacks;

namespace NeuronMocap.Native;

// The registered C callbacks, one of each kind. Each is replaced together with its object.
internal sealed unsafe class NativeCallbacks : IVendorCallbacks
{
    private const int StackText = 512;

    private volatile Registration? _frame;
    private volatile Registration? _calculation;
    private volatile Registration? _status;
    private volatile Registration? _command;
    private volatile HeaderLayout _frameHeaders = HeaderVariable.Read();

    public HeaderLayout FrameHeaders
    {
        get => _frameHeaders;
        set => _frameHeaders = value;
    }

    public bool WantsFrames => _frame is not null;

    public bool WantsCalculation => _calculation is not null;

    public bool WantsCommands => _command is not null;

    public void SetFrame(IntPtr customObject, IntPtr function) => _frame = Registration.Of(customObject, function);

    public void SetCalculation(IntPtr customObject, IntPtr function) => _calculation = Registration.Of(customObject, function);

    public void SetStatus(IntPtr customObject, IntPtr function) => _status = Registration.Of(customObject, function);

    public void SetCommand(IntPtr customObject, IntPtr function) => _command = Registration.Of(customObject, function);

    public void OnFrame(IntPtr socket, IntPtr header, IntPtr data) => _frame?.Call(socket, header, data);

    public void OnCalculation(IntPtr socket, IntPtr header, IntPtr data) => _calculation?.Call(socket, header, data);

    public void OnCommand(IntPtr socket, IntPtr header, IntPtr data) => _command?.Call(socket, header, data);

    public void OnStatus(IntPtr socket, SocketState status, string message)
    {
        if (_status is not { } registration)
            return;

        int length = Encoding.UTF8.GetMaxByteCount(message.Length) + 1;
        Span<byte> text = length <= StackText ? stackalloc byte[StackText] : new byte[length];
        text[Encoding.UTF8.GetBytes(message, text)] = 0;
        fixed (byte* start = text)
            registration.Call(socket, (int)status, start);
    }

    // On Windows callbacks are stdcall. Other systems have one convention.
    private sealed class Registration(IntPtr customObject, IntPtr function)
    {
        public static Registration? Of(IntPtr customObject, IntPtr function) =>
            function == IntPtr.Zero ? null : new Registration(customObject, function);

        public void Call(IntPtr socket, IntPtr header, IntPtr data) =>
            ((delegate* unmanaged[Stdcall]<IntPtr, IntPtr, IntPtr, IntPtr, void>)function)(customObject, socket, header, data);

        public void Call(IntPtr socket, int status, byte* message) =>
            ((delegate* unmanaged[Stdcall]<IntPtr, IntPtr, int, byte*, void>)function)(customObject, socket, status, message);
    }
}
