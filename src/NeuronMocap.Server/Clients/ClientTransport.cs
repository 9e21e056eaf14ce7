using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Server.Clients;

/// <summary>The connection of one client: a socket of our own listener, or a connection that another server accepted.</summary>
/// <remarks>One thread at a time sends, and one receives. Any thread may end the connection.</remarks>
internal abstract class ClientTransport : IDisposable
{
    public abstract EndPoint? RemoteEndPoint { get; }

    // Whether the client has closed its side, and nothing of what it sent is left to receive. Thread-safe.
    public abstract bool IsLeft { get; }

    /// <summary>Blocks until the bytes are handed over, or until the client has not read for too long.</summary>
    /// <returns>Success, TimedOut or WouldBlock if the client does not read, or another error if the connection has ended.</returns>
    /// <exception cref="ObjectDisposedException">The connection was ended on this side.</exception>
    public abstract SocketError TrySend(byte[] buffer, int offset, int count, out int sent);

    /// <summary>Prepares <see cref="TrySendNow"/>. From then on, only <see cref="TrySend"/> waits.</summary>
    /// <returns>False if every send may wait.</returns>
    public virtual bool TryStopWaiting() => false;

    /// <summary>Hands over as many bytes as there is room for. Only after <see cref="TryStopWaiting"/>, and not during <see cref="TrySend"/>.</summary>
    /// <returns>Success, or WouldBlock if there is no room, or another error if the connection has ended.</returns>
    /// <exception cref="ObjectDisposedException">The connection was ended on this side.</exception>
    public virtual SocketError TrySendNow(byte[] buffer, int offset, int count, out int sent) =>
        throw new NotSupportedException("Every send of this transport may wait: TryStopWaiting returns false.");

    /// <summary>Waits until there is room. Only after <see cref="TryStopWaiting"/>.</summary>
    /// <param name="milliseconds">The longest wait.</param>
    /// <returns>Whether there is room, or the connection has failed.</returns>
    /// <exception cref="ObjectDisposedException">The connection was ended on this side.</exception>
    public virtual bool HasRoom(int milliseconds) => true;

    /// <summary>Takes bytes of the client that have already arrived. Only after <see cref="TryStopWaiting"/>.</summary>
    /// <param name="room">Receives the bytes.</param>
    /// <param name="count">Their number; 0 when the client has closed its side.</param>
    /// <returns>False if nothing has arrived, or if the connection has failed: the next send reports that.</returns>
    /// <exception cref="ObjectDisposedException">The connection was ended on this side.</exception>
    public virtual bool TryReceiveNow(ArraySegment<byte> room, out int count)
    {
        count = 0;
        return false;
    }

    /// <summary>Waits for bytes of the client.</summary>
    /// <returns>Their number; 0 when the client has closed its side.</returns>
    /// <exception cref="SocketException">The connection has failed.</exception>
    /// <exception cref="ObjectDisposedException">The connection was ended on this side.</exception>
    public abstract ValueTask<int> ReceiveAsync(Memory<byte> room);

    /// <summary>Blocks until bytes of the client arrive.</summary>
    /// <param name="room">Receives the bytes.</param>
    /// <param name="timeout">Longest time in milliseconds; 0 for no limit. After it the connection cannot receive any more.</param>
    /// <inheritdoc cref="ReceiveAsync"/>
    public abstract int Receive(ArraySegment<byte> room, int timeout);

    // The client reads what was sent, and then sees the end.
    public abstract void EndSending();

    // The end discards what the client has not read, instead of trying to deliver it.
    public abstract void DropUnsent();

    public abstract void Dispose();
}
