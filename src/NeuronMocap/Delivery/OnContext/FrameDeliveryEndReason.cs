namespace NeuronMocap;

/// <summary>The reason why a <see cref="FrameDelivery"/> has ended.</summary>
public enum FrameDeliveryEndReason
{
    /// <summary>The delivery was disposed.</summary>
    Disposed,

    /// <summary>The reader has stopped for good, or was disposed.</summary>
    ReaderStopped,

    /// <summary>The context takes no more posts: the window was closed, its message loop ended, or its thread ended.</summary>
    ContextGone,

    /// <summary>The context ran a post at once, on the thread that posted, so the handlers would not run on the window's thread.</summary>
    NotPosted,
}
