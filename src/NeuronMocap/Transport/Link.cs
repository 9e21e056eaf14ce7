using System.Net;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// One attempt to receive: opened once, received from once, closed by anyone at any time. Closing the socket is what ends both waits.
internal abstract class Link : IDisposable
{
    public EndPoint? LocalEndPoint { get; protected set; }

    public EndPoint? RemoteEndPoint { get; protected set; }

    // Bytes that the system keeps for datagrams until they are read; null for TCP.
    public int? ReceiveBufferSize { get; protected set; }

    // Whether the bytes come in datagrams, each with its sender.
    public virtual bool IsDatagrams => false;

    // Where packets are delivered.
    public abstract ReceiveThread ReceiveThread { get; }

    // What the status messages call the other side.
    public abstract string Target { get; }

    // Completes with the reason of failure, with None when the link stands, or with Requested when it was closed first. Throws nothing
    // that the network can cause.
    public abstract Task<LinkEnd> OpenAsync(CancellationToken cancellationToken);

    // Delivers packets until the link ends; the listener hears what else happens to the link. Completes with the reason: Requested when it was
    // closed before it ended by itself. Throws nothing that the network can cause.
    public abstract Task<LinkEnd> ReceiveAsync(IPacketReceiver receiver, ILinkListener? listener);

    // Sends a request to the other side, where there is one that takes requests. Any thread, while the link stands.
    public virtual bool TrySend(ReadOnlySpan<byte> bytes) => false;

    public abstract void Close();

    public void Dispose() => Close();
}

internal readonly record struct LinkEnd(ConnectionReason Reason, string Message)
{
    // Whether no other attempt can follow, whatever the options say.
    public bool IsFinal { get; init; }

    public static LinkEnd None => new(ConnectionReason.None, string.Empty);

    public static LinkEnd Requested => new(ConnectionReason.Requested, "Stopped by the caller.");
}
