using NeuronMocap.Protocol;

namespace NeuronMocap.Frames;

// The one way in which packets become the frames of a consumer. Frames are lent one after the other. Those of one kind take turns: while one is
// valid, those that were lent before it are not, and whoever kept one of them finds out. One that was found out is not lent again, so that it
// never comes back to life. One thread at a time.
internal sealed class FramePool(FrameFormat format, int count)
{
    // A prime: with as many frames as there are avatars, or a multiple, the same avatar would get the same one every time.
    public const int OfHandlers = 31;

    // Of one avatar, or of a reader whose frames are read one by one.
    public const int OfTakers = 7;

    private readonly Turns[] _turns = new Turns[(int)PacketKind.StudioCalculation + 1];

    // Makes the frames of a kind before the first one comes.
    public void Prepare(PacketKind kind) => _turns[(int)kind].Frames ??= CreateAll(kind);

    // Valid until its Expire, which comes before the packet's memory is used again.
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
