using NeuronMocap.Protocol;

namespace NeuronMocap.Frames;

// Turns packets into the frames of a consumer; all consumers use it. Frames of one kind are reused in turn. Only the newest of them is valid; a consumer
// that kept an earlier frame gets exceptions from it. After such an exception a frame is not reused, so it never becomes valid again. One thread at a
// time.
internal sealed class FramePool(FrameFormat format, int count)
{
    // A prime. If the number were a multiple of the number of avatars, each avatar would always get the same frames.
    public const int OfHandlers = 31;

    // For one avatar, or for a reader whose frames are read one by one.
    public const int OfTakers = 7;

    private readonly Turns[] _turns = new Turns[(int)PacketKind.StudioCalculation + 1];

    // Makes the frames of a kind before the first packet arrives.
    public void Prepare(PacketKind kind) => _turns[(int)kind].Frames ??= CreateAll(kind);

    // The frame is valid until its Expire, which is called before the packet's memory is reused.
    public AvatarFrame Lend(in ReceivedPacket packet)
    {
        ref Turns turns = ref _turns[(int)packet.Kind];
        AvatarFrame[] frames = turns.Frames ??= CreateAll(packet.Kind);
        int place = turns.Next;
        turns.Next = place + 1 < frames.Length ? place + 1 : 0;
        AvatarFrame frame = frames[place];
        if (frame.WasReadLate)
            frame = frames[place] = Create(packet.Kind);

        frame.Borrow(packet);
        return frame;
    }

    private AvatarFrame[] CreateAll(PacketKind kind)
    {
        var frames = new AvatarFrame[count];
        for (int i = 0; i < frames.Length; i++)
            frames[i] = Create(kind);

        return frames;
    }

    private AvatarFrame Create(PacketKind kind) => kind switch
    {
        PacketKind.Motion => new MotionFrame(format),
        PacketKind.Calculation => new CalculationFrame(),
        _ => new StudioCalculationFrame(),
    };

    private struct Turns
    {
        public AvatarFrame[]? Frames;
        public int Next;
    }
}
