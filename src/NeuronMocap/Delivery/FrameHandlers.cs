namespace NeuronMocap.Delivery;

// The handlers of one kind of frame, for callers that do not know the kind.
internal interface IFrameHandlers
{
    bool IsEmpty { get; }

    void Invoke(AvatarFrame frame);
}

internal sealed class FrameHandlers<TFrame>(Action<Exception> failed) : HandlerList<TFrame>(failed), IFrameHandlers
    where TFrame : AvatarFrame
{
    void IFrameHandlers.Invoke(AvatarFrame frame) => Invoke((TFrame)frame);
}
