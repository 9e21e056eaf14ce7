using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using NeuronMocap.Compatibility;
using NeuronMocap.Native.Host;

namespace NeuronMocap.Native;

// The exported functions: manual section 2.3. They only convert; VendorFunctions does the work, as for the C# functions. They do not throw, because
// the whole body of each function runs behind its guard.
internal static unsafe partial class Exports
{
    private const int OffWork = 2;

    [UnmanagedCallersOnly(EntryPoint = nameof(BRRegisterFrameDataCallback), CallConvs = [typeof(CallConvCdecl)])]
    public static void BRRegisterFrameDataCallback(IntPtr customedObj, IntPtr handle) => ExportGuard.Run(
        (customedObj, handle), static what => Library.Callbacks.SetFrame(what.customedObj, what.handle));

    [UnmanagedCallersOnly(EntryPoint = nameof(BRRegisterCalculationDataCallback), CallConvs = [typeof(CallConvCdecl)])]
    public static void BRRegisterCalculationDataCallback(IntPtr customedObj, IntPtr handle) => ExportGuard.Run(
        (customedObj, handle), static what => Library.Callbacks.SetCalculation(what.customedObj, what.handle));

    [UnmanagedCallersOnly(EntryPoint = nameof(BRRegisterSocketStatusCallback), CallConvs = [typeof(CallConvCdecl)])]
    public static void BRRegisterSocketStatusCallback(IntPtr customedObj, IntPtr handle) => ExportGuard.Run(
        (customedObj, handle), static what => Library.Callbacks.SetStatus(what.customedObj, what.handle));

    [UnmanagedCallersOnly(EntryPoint = nameof(BRConnectTo), CallConvs = [typeof(CallConvCdecl)])]
    public static IntPtr BRConnectTo(IntPtr serverIP, int nPort) => ExportGuard.Call(
        (serverIP, nPort), static to => Library.Functions.Connect(TextOf(to.serverIP), to.nPort), IntPtr.Zero);

    [UnmanagedCallersOnly(EntryPoint = nameof(BRStartUDPServiceAt), CallConvs = [typeof(CallConvCdecl)])]
    public static IntPtr BRStartUDPServiceAt(int nPort) => ExportGuard.Call(nPort, static port => Library.Functions.StartUdpService(port), IntPtr.Zero);

    [UnmanagedCallersOnly(EntryPoint = nameof(BRCloseSocket), CallConvs = [typeof(CallConvCdecl)])]
    public static void BRCloseSocket(IntPtr sockRef) => ExportGuard.Run(sockRef, static socket => VendorFunctions.Close(socket));

    [UnmanagedCallersOnly(EntryPoint = nameof(BRGetSocketStatus), CallConvs = [typeof(CallConvCdecl)])]
    public static int BRGetSocketStatus(IntPtr sockRef) => ExportGuard.Call(sockRef, static socket => (int)VendorFunctions.GetStatus(socket), OffWork);

    // entry.c calls this function first. It creates the objects that all functions share.
    [UnmanagedCallersOnly(EntryPoint = nameof(BRGetLastErrorMessage), CallConvs = [typeof(CallConvCdecl)])]
    public static IntPtr BRGetLastErrorMessage() => ExportGuard.Call(
        0,
        static nothing =>
        {
            _ = Library.Functions;
            return LastError.Pointer;
        },
        ExportGuard.NoMemory);

    private static string TextOf(IntPtr text) => Marshal.PtrToStringUTF8(text) ?? string.Empty;
}
