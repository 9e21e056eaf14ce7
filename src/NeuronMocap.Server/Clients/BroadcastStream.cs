using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server.Clients;

// The stream of one port: its content, its log and its listener. The broadcaster's gate guards the state of the port.
internal sealed class BroadcastStream(BroadcastContent content, FrameLog? log, DataCommandReplies? replies)
{
    public BroadcastContent Content => content;

    // Null if every recipient gets the whole take at its own speed.
    public FrameLog? Log => log;

    // Null if commands are not answered.
    public DataCommandReplies? Replies => replies;

    // Null if commands are not passed to another server.
    public RequestForwarder? Forwarder { get; init; }

    // Whether this is the calculation stream on its own port.
    public bool IsBeside { get; init; }

    // Whether TCP clients get every packet in a separate write.
    public bool IsPacketwise { get; init; }

    // Whether the thread that publishes sends to clients that keep up.
    public bool IsDirect { get; init; }

    // Null if only UDP destinations are served.
    public ClientListener? Listener { get; private set; }

    public bool HasAccepted { get; set; }

    // Whether a client received everything; without a port also: whether a UDP destination did.
    public bool HasServed { get; set; }

    // Whether an unpaced broadcast waits for a client that receives everything. A reader that left early may come back.
    public bool AwaitsClients => Listener is not null || HasAccepted;

    public void Listen(ClientListener listener) => Listener = listener;

    public FrameFeed CreateFeed(bool isSingle) => log is null ? content.CreateFeed(isSingle) : new LiveFeed(log, isSingle);
}
