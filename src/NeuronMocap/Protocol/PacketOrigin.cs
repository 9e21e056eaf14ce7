namespace NeuronMocap.Protocol;

// Who a packet is from: the number that users see as the frame's source, and how often another sender went on as that source. In one number, because
// every packet carries it. A new run may count its frames from anywhere: what follows is neither late nor a gap.
internal static class PacketOrigin
{
    private const int RunShift = 24;

    // As many sources as there can be; then numbers begin again.
    private const int SourceMask = (1 << RunShift) - 1;

    public static int Create(int source, int run) => (source & SourceMask) | (run << RunShift);

    public static int SourceOf(int origin) => origin & SourceMask;
}
