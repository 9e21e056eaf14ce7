namespace NeuronMocap.Compatibility.Callbacks;

internal sealed partial class CallbackGate
{
    private static void FenceDelivery() => Interlocked.MemoryBarrier();

    private static void FenceClosing() => Interlocked.MemoryBarrier();
}
