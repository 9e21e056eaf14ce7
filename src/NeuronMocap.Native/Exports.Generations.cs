using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using NeuronMocap.Compatibility;
using NeuronMocap.Native.Host;

namespace NeuronMocap.Native;

// Not in the vendor's library: the vendor had a separate library for each generation.
internal static unsafe partial class Exports
{
    // The numbers of BRHeaderLayout are those of HeaderLayout.
    [UnmanagedCallersOnly(EntryPoint = nameof(BRSetHeaderLayout), CallConvs = [typeof(CallConvCdecl)])]
    public static void BRSetHeaderLayout(int layout) => ExportGuard.Run(layout, static layout =>
    {
        if (layout is (int)HeaderLayout.New or (int)HeaderLayout.Old)
            Library.Callbacks.FrameHeaders = (HeaderLayout)layout;
        else
            LastError.Set($"Header layout {layout} does not exist.");
    });
}
