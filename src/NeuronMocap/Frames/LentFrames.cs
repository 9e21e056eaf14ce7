using NeuronMocap.Protocol;

namespace NeuronMocap.Frames;

// Frames that are lent one after the other. They take turns: while one is valid, those that were lent before it are not, and whoever kept one
// of them finds out. One that was found out is not lent again, so that it never comes back to life. One thread at a time.
internal sealed class LentFrames<TFrame>
    where TFrame : AvatarFrame
{
    // A prime: with as many frames as there are avatars, or a multiple, the same avatar would get the same one every time.
    public const int OfHandlers = 31;

    // Of one avatar, or of a reader whose frames are read one by one.
    public const int OfTakers = 7;

    private readonly Func<TFrame> _create;
    private readonly TFrame[] _frames;
    private int _next;

    public LentFrames(Func<TFrame> create, int count)
    {
        _create = create;
        _frames = new TFrame[count];
        for (int i = 0; i < count; i++)
            _frames[i] = create();
    }

    // Valid until its Expire, which comes before the packet's memory is used again.
    public TFrame Lend(in ReceivedPacket packet)
    {
        int place = _next;
        _next = place + 1 < _frames.Length ? place + 1 : 0;
        TFrame frame = _frames[place];
        if (frame.WasReadLate)
            frame = _frames[place] = _create();

        frame.Borrow(packet);
        return frame;
    }
}
