using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// Is notified about the links that bring packets. The threads that open, receive and close links call it, one after another.
internal interface ILinkListener
{
    // Gets every piece of bytes with its sender, before it is parsed; null if recording is not possible. Always the same object.
    StreamTap? Tap { get; }

    // A new connection is established; its bytes do not continue the earlier ones.
    void OnLinkOpened();

    // The connection has ended, or was never established.
    void OnLinkClosed();
}
