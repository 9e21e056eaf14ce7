using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using NeuronMocap.Compatibility;
using NeuronMocap.Native.Host;

namespace NeuronMocap.Native;

// Commands on the data connection, b11 and b12 (protocol.md section 7). BOOL is an int.
internal static unsafe partial class Exports
{
    [UnmanagedCallersOnly(EntryPoint = nameof(BRRegisterCommandDataCallback), CallConvs = [typeof(CallConvCdecl)])]
    public static void BRRegisterCommandDataCallback(IntPtr customedObj, IntPtr handle) => ExportGuard.Run(
        (customedObj, handle), static what => Library.Callbacks.SetCommand(what.customedObj, what.handle));

    [UnmanagedCallersOnly(EntryPoint = nameof(BRCommandFetchDataFromServer), CallConvs = [typeof(CallConvCdecl)])]
    public static int BRCommandFetchDataFromServer(IntPtr sockRef, int cmdId) => ExportGuard.Call(
        (sockRef, cmdId), static what => IntOf(VendorFunctions.Fetch(what.sockRef, what.cmdId, avatar: 0)), failure: 0);

    [UnmanagedCallersOnly(EntryPoint = nameof(BRCommandFetchAvatarDataFromServer), CallConvs = [typeof(CallConvCdecl)])]
    public static int BRCommandFetchAvatarDataFromServer(IntPtr sockRef, int avatarIndex, int cmdId) => ExportGuard.Call(
        (sockRef, avatarIndex, cmdId), static what => IntOf(VendorFunctions.Fetch(what.sockRef, what.cmdId, what.avatarIndex)), failure: 0);

    [UnmanagedCallersOnly(EntryPoint = nameof(BRRegisterAutoSyncParmeter), CallConvs = [typeof(CallConvCdecl)])]
    public static int BRRegisterAutoSyncParmeter(IntPtr sockRef, int cmdId) => ExportGuard.Call(
        (sockRef, cmdId), static what => IntOf(VendorFunctions.Register(what.sockRef, what.cmdId)), failure: 0);

    [UnmanagedCallersOnly(EntryPoint = nameof(BRUnregisterAutoSyncParmeter), CallConvs = [typeof(CallConvCdecl)])]
    public static int BRUnregisterAutoSyncParmeter(IntPtr sockRef, int cmdId) => ExportGuard.Call(
        (sockRef, cmdId), static what => IntOf(VendorFunctions.Unregister(what.sockRef, what.cmdId)), failure: 0);
}
