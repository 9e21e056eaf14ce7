using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using NeuronMocap.Compatibility;
using NeuronMocap.Native.Host;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Native;

// The command channel of b17 and b18: manual sections 2.3.9 to 2.3.14. The functions return a bool of one byte. A caller that declares an int reads
// garbage in the other bytes.
internal static unsafe partial class Exports
{
    private const int UnknownOrder = 6;

    [UnmanagedCallersOnly(EntryPoint = nameof(BRConnectCmd), CallConvs = [typeof(CallConvCdecl)])]
    public static IntPtr BRConnectCmd(IntPtr serverIP, int nPort) => ExportGuard.Call(
        (serverIP, nPort), static to => Library.Functions.ConnectCommands(TextOf(to.serverIP), to.nPort), IntPtr.Zero);

    [UnmanagedCallersOnly(EntryPoint = nameof(ZeroOut), CallConvs = [typeof(CallConvCdecl)])]
    public static int ZeroOut(IntPtr sockRef, int avatarIndex) => ExportGuard.Call(
        (sockRef, avatarIndex), static what => IntOf(VendorFunctions.ZeroOut(what.sockRef, what.avatarIndex)), failure: 0);

    [UnmanagedCallersOnly(EntryPoint = nameof(ZeroOutAll), CallConvs = [typeof(CallConvCdecl)])]
    public static int ZeroOutAll(IntPtr sockRef) => ExportGuard.Call(sockRef, static socket => IntOf(VendorFunctions.ZeroOutAll(socket)), failure: 0);

    [UnmanagedCallersOnly(EntryPoint = nameof(GetBvhRotation), CallConvs = [typeof(CallConvCdecl)])]
    public static int GetBvhRotation(IntPtr sockRef, int* order) => ExportGuard.Call(
        (sockRef, order: (IntPtr)order),
        static what =>
        {
            int* order = (int*)what.order;
            if (order is null)
                return 0;

            *order = UnknownOrder;
            bool succeeded = VendorFunctions.TryGetRotationOrder(what.sockRef, out RotationOrder answer);
            if (succeeded)
                *order = (int)answer;

            return IntOf(succeeded);
        },
        failure: 0);

    [UnmanagedCallersOnly(EntryPoint = nameof(GetBoneSize), CallConvs = [typeof(CallConvCdecl)])]
    public static int GetBoneSize(IntPtr sockRef, int avatarIndex, BoneDimension* boneSize) => AskBoneSize(sockRef, avatarIndex, boneSize, nameof(GetBoneSize));

    // The same function, with the name in the manual's heading.
    [UnmanagedCallersOnly(EntryPoint = nameof(BRGetBoneSize), CallConvs = [typeof(CallConvCdecl)])]
    public static int BRGetBoneSize(IntPtr sockRef, int avatarIndex, BoneDimension* boneSize) => AskBoneSize(sockRef, avatarIndex, boneSize, nameof(BRGetBoneSize));

    [UnmanagedCallersOnly(EntryPoint = nameof(GetBvhHeader), CallConvs = [typeof(CallConvCdecl)])]
    public static int GetBvhHeader(IntPtr sockRef, int avatarIndex, byte* data, int len) => ExportGuard.Call(
        (sockRef, avatarIndex, data: (IntPtr)data, len),
        static what =>
        {
            if (what.data == IntPtr.Zero || what.len <= 0 || !VendorFunctions.TryGetBvhHeader(what.sockRef, what.avatarIndex, out byte[]? text))
                return 0;

            text.AsSpan(0, Math.Min(what.len, text.Length)).CopyTo(new Span<byte>((void*)what.data, what.len));
            return 1;
        },
        failure: 0);

    private static int AskBoneSize(IntPtr sockRef, int avatarIndex, BoneDimension* boneSize, string name) => ExportGuard.Call(
        (sockRef, avatarIndex, boneSize: (IntPtr)boneSize),
        static what =>
        {
            var boneSize = (BoneDimension*)what.boneSize;
            if (boneSize is null)
                return 0;

            *boneSize = default;
            bool succeeded = VendorFunctions.TryGetBoneDimensions(what.sockRef, what.avatarIndex, out BoneDimensions answer);
            if (succeeded)
                *boneSize = new BoneDimension(answer);

            return IntOf(succeeded);
        },
        failure: 0,
        name);

    private static int IntOf(bool value) => value ? 1 : 0;
}
