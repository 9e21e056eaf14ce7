namespace NeuronMocap.Protocol;

// Who a packet is from: the number that users see as the frame's sender, and how often that sender started anew. Both in one number, because every
// packet carries it. A new run may count its frames from anywhere: what follows is neither late nor a gap.
internal static class PacketOrigin
{
    private const int RunShift = 24;

    // The largest number of senders; after it the numbers begin again.
    private const int SenderMask = (1 << RunShift) - 1;

    public static int Create(int sender, int run) => (sender & SenderMask) | (run << RunShift);

    public static int SenderOf(int origin) => origin & SenderMask;
}
