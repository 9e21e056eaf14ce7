using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using NeuronMocap.Compatibility;

namespace NeuronMocap.Native;

// Commands on the data connection, b11 and b12 (protocol.md section 7). BOOL is an int.
internal static unsafe partial class Exports
{
    [UnmanagedCallersOnly(EntryPoint = nameof(BRRegisterCommandDataCallback), CallConvs = [typeof(CallConvCdecl)])]
    public static void BRRegisterCommandDataCallback(IntPtr customedObj, IntPtr handle) => Callbacks.SetCommand(customedObj, handle);

    [UnmanagedCallersOnly(EntryPoint = nameof(BRCommandFetchDataFromServer), CallConvs = [typeof(CallConvCdecl)])]
    public static int BRCommandFetchDataFromServer(IntPtr sockRef, int cmdId) => IntOf(VendorFunctions.Fetch(sockRef, cmdId, avatar: 0));

    [UnmanagedCallersOnly(EntryPoint = nameof(BRCommandFetchAvatarDataFromServer), CallConvs = [typeof(CallConvCdecl)])]
    public static int BRCommandFetchAvatarDataFromServer(IntPtr sockRef, int avatarIndex, int cmdId) =>
        IntOf(VendorFunctions.Fetch(sockRef, cmdId, avatarIndex));

    [UnmanagedCallersOnly(EntryPoint = nameof(BRRegisterAutoSyncParmeter), CallConvs = [typeof(CallConvCdecl)])]
    public static int BRRegisterAutoSyncParmeter(IntPtr sockRef, int cmdId) => IntOf(VendorFunctions.Register(sockRef, cmdId));

    [UnmanagedCallersOnly(EntryPoint = nameof(BRUnregisterAutoSyncParmeter), CallConvs = [typeof(CallConvCdecl)])]
    public static int BRUnregisterAutoSyncParmeter(IntPtr sockRef, int cmdId) => IntOf(VendorFunctions.Unregister(sockRef, cmdId));
}
