using System.Net;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// One attempt to receive. It is opened once and received from once; any thread can close it at any time. Closing the socket ends both waits.
internal abstract class Link : IDisposable
{
    public EndPoint? LocalEndPoint { get; protected set; }

    public EndPoint? RemoteEndPoint { get; protected set; }

    // Size in bytes of the system's buffer for datagrams; null for TCP.
    public int? ReceiveBufferSize { get; protected set; }

    // Whether the bytes arrive in datagrams, each with its sender.
    public virtual bool IsDatagrams => false;

    // The kind of thread that delivers packets.
    public abstract ReceiveThread ReceiveThread { get; }

    // Name of the other side in status messages.
    public abstract string Target { get; }

    // Completes with the reason for a failure, with None when the connection is established, or with Requested when it was closed first. Network errors
    // never cause an exception.
    public abstract Task<LinkEnd> OpenAsync(CancellationToken cancellationToken);

    // Delivers packets until the link ends; the listener is notified of other events. Completes with the reason, which is Requested if it was closed
    // first. Network errors never cause an exception.
    public abstract Task<LinkEnd> ReceiveAsync(IPacketReceiver receiver, ILinkListener? listener);

    // Sends a request to the other side, if it accepts requests. Any thread, while connected.
    public virtual bool TrySend(ReadOnlySpan<byte> bytes) => false;

    public abstract void Close();

    public void Dispose() => Close();
}

internal readonly record struct LinkEnd(ConnectionReason Reason, string Message)
{
    // Whether no further attempt can follow, regardless of the options.
    public bool IsFinal { get; init; }

    public static LinkEnd None => new(ConnectionReason.None, string.Empty);

    public static LinkEnd Requested => new(ConnectionReason.Requested, "Stopped by the caller.");
}
