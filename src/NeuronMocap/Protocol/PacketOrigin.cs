namespace NeuronMocap.Protocol;

// The origin of a packet: the sender number that users see, and how often that sender restarted. Both are in one number, because every packet carries it.
// A new run can start its frame numbers anywhere, so its frames are neither late nor a gap.
internal static class PacketOrigin
{
    private const int RunShift = 24;

    // The largest number of senders; the numbers then start again.
    private const int SenderMask = (1 << RunShift) - 1;

    public static int Create(int sender, int run) => (sender & SenderMask) | (run << RunShift);

    public static int SenderOf(int origin) => origin & SenderMask;
}
