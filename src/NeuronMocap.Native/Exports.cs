using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using NeuronMocap.Compatibility;
using NeuronMocap.Native.Host;

namespace NeuronMocap.Native;

// What the library exports: manual section 2.3. Only converts; VendorFunctions does the work, as for the C# functions. None throws: an exception
// that left one would end the process. What opens and closes sockets is caught here, as there memory and threads may run out.
internal static unsafe partial class Exports
{
    private static readonly NativeCallbacks Callbacks = new();
    private static readonly VendorFunctions Functions = new(Callbacks);

    static Exports()
    {
        Entry.SetHandlers();
        // Nobody asked for text in the program's standard error.
        CompatibilityEvents.CallbackFailed += static _ => { };
    }

    [UnmanagedCallersOnly(EntryPoint = nameof(BRRegisterFrameDataCallback), CallConvs = [typeof(CallConvCdecl)])]
    public static void BRRegisterFrameDataCallback(IntPtr customedObj, IntPtr handle) => Callbacks.SetFrame(customedObj, handle);

    [UnmanagedCallersOnly(EntryPoint = nameof(BRRegisterCalculationDataCallback), CallConvs = [typeof(CallConvCdecl)])]
    public static void BRRegisterCalculationDataCallback(IntPtr customedObj, IntPtr handle) => Callbacks.SetCalculation(customedObj, handle);

    [UnmanagedCallersOnly(EntryPoint = nameof(BRRegisterSocketStatusCallback), CallConvs = [typeof(CallConvCdecl)])]
    public static void BRRegisterSocketStatusCallback(IntPtr customedObj, IntPtr handle) => Callbacks.SetStatus(customedObj, handle);

    [UnmanagedCallersOnly(EntryPoint = nameof(BRConnectTo), CallConvs = [typeof(CallConvCdecl)])]
    public static IntPtr BRConnectTo(IntPtr serverIP, int nPort) => Open(() => Functions.Connect(TextOf(serverIP), nPort));

    [UnmanagedCallersOnly(EntryPoint = nameof(BRStartUDPServiceAt), CallConvs = [typeof(CallConvCdecl)])]
    public static IntPtr BRStartUDPServiceAt(int nPort) => Open(() => Functions.StartUdpService(nPort));

    [UnmanagedCallersOnly(EntryPoint = nameof(BRCloseSocket), CallConvs = [typeof(CallConvCdecl)])]
    public static void BRCloseSocket(IntPtr sockRef)
    {
        try
        {
            VendorFunctions.Close(sockRef);
        }
        catch (Exception exception)
        {
            LastError.Set(exception.Message);
        }
    }

    [UnmanagedCallersOnly(EntryPoint = nameof(BRGetSocketStatus), CallConvs = [typeof(CallConvCdecl)])]
    public static int BRGetSocketStatus(IntPtr sockRef) => (int)VendorFunctions.GetStatus(sockRef);

    [UnmanagedCallersOnly(EntryPoint = nameof(BRGetLastErrorMessage), CallConvs = [typeof(CallConvCdecl)])]
    public static IntPtr BRGetLastErrorMessage() => LastError.Pointer;

    private static IntPtr Open(Func<IntPtr> open)
    {
        try
        {
            return open();
        }
        catch (Exception exception)
        {
            LastError.Set(exception.Message);
            return IntPtr.Zero;
        }
    }

    private static string TextOf(IntPtr text) => Marshal.PtrToStringUTF8(text) ?? string.Empty;
}
