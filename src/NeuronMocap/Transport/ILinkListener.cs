using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// Hears what becomes of the links that packets arrive over: on the threads that open, receive and close them, one after the other.
internal interface ILinkListener
{
    // Is shown every piece of bytes with its sender, before anybody looks for packets in it; null where nobody can record it. Always the same one.
    StreamTap? Tap { get; }

    // A new connection stands; what comes over it does not continue what came before.
    void OnLinkOpened();

    // The connection is gone, or never came to stand.
    void OnLinkClosed();
}
