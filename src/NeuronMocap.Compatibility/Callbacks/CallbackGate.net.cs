using System.Runtime.CompilerServices;

namespace NeuronMocap.Compatibility.Callbacks;

// Closing is rare and callbacks are not, so the closing thread makes the fence of both sides: the system interrupts every thread of the process for it.
internal sealed partial class CallbackGate
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void FenceDelivery()
    {
    }

    private static void FenceClosing() => Interlocked.MemoryBarrierProcessWide();
}
