using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using NeuronMocap.Compatibility;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Native;

// The command channel of b17 and b18: manual sections 2.3.9 to 2.3.14. They return a bool, which is one byte; who takes it for an int reads more of them.
internal static unsafe partial class Exports
{
    private const int UnknownOrder = 6;

    [UnmanagedCallersOnly(EntryPoint = nameof(BRConnectCmd), CallConvs = [typeof(CallConvCdecl)])]
    public static IntPtr BRConnectCmd(IntPtr serverIP, int nPort) =>
        Open(() => Functions.ConnectCommands(TextOf(serverIP), nPort));

    [UnmanagedCallersOnly(EntryPoint = nameof(ZeroOut), CallConvs = [typeof(CallConvCdecl)])]
    public static int ZeroOut(IntPtr sockRef, int avatarIndex) => IntOf(VendorFunctions.ZeroOut(sockRef, avatarIndex));

    [UnmanagedCallersOnly(EntryPoint = nameof(ZeroOutAll), CallConvs = [typeof(CallConvCdecl)])]
    public static int ZeroOutAll(IntPtr sockRef) => IntOf(VendorFunctions.ZeroOutAll(sockRef));

    [UnmanagedCallersOnly(EntryPoint = nameof(GetBvhRotation), CallConvs = [typeof(CallConvCdecl)])]
    public static int GetBvhRotation(IntPtr sockRef, int* order)
    {
        if (order is null)
            return 0;

        bool told = VendorFunctions.TryGetRotationOrder(sockRef, out RotationOrder answer);
        *order = told ? (int)answer : UnknownOrder;
        return IntOf(told);
    }

    [UnmanagedCallersOnly(EntryPoint = nameof(GetBoneSize), CallConvs = [typeof(CallConvCdecl)])]
    public static int GetBoneSize(IntPtr sockRef, int avatarIndex, BoneDimension* boneSize)
    {
        if (boneSize is null)
            return 0;

        bool told = VendorFunctions.TryGetBoneDimensions(sockRef, avatarIndex, out BoneDimensions answer);
        *boneSize = new BoneDimension(answer);
        return IntOf(told);
    }

    [UnmanagedCallersOnly(EntryPoint = nameof(GetBvhHeader), CallConvs = [typeof(CallConvCdecl)])]
    public static int GetBvhHeader(IntPtr sockRef, int avatarIndex, byte* data, int len)
    {
        if (data is null || len <= 0 || !VendorFunctions.TryGetBvhHeader(sockRef, avatarIndex, out byte[]? text))
            return 0;

        text.AsSpan(0, Math.Min(len, text.Length)).CopyTo(new Span<byte>(data, len));
        return 1;
    }

    private static int IntOf(bool value) => value ? 1 : 0;
}
