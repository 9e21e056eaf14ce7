using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server.Clients;

// What goes to one port: its content, where it is published, and who listens there. The port's state is guarded by the broadcaster's gate.
internal sealed class BroadcastStream(BroadcastContent content, FrameLog? log, DataCommandReplies? replies)
{
    public BroadcastContent Content => content;

    // Null where every recipient gets the whole take at its own speed.
    public FrameLog? Log => log;

    // Null where commands are not answered.
    public DataCommandReplies? Replies => replies;

    // The calculation stream beside the motion, on a port of its own.
    public bool IsBeside { get; init; }

    // Whether TCP clients get every packet in a write of its own.
    public bool IsPacketwise { get; init; }

    // Null where only UDP destinations are served.
    public ClientListener? Listener { get; private set; }

    public bool HasAccepted { get; set; }

    // Whether a TCP client had everything.
    public bool HasServed { get; set; }

    public void Listen(ClientListener listener) => Listener = listener;

    public FrameFeed CreateFeed(bool isSingle) => log is null ? content.CreateFeed(isSingle) : new LiveFeed(log, isSingle);
}
