using System.Net.Sockets;
using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server.Clients;

/// <summary>
/// A client's connection. Clients need not send anything (protocol.md section 4.1); what they send all the same is read and thrown away,
/// because a socket that is closed over unread bytes resets the connection and takes the client's last frames with it.
/// </summary>
internal sealed class TcpClientSession : Recipient
{
    // Bounds what the system keeps for a client that does not read. By default it is megabytes, which is a minute of old frames.
    private const int SendBufferSize = 256 * 1024;

    // The time limit of a write counts from its begin, however much the client takes meanwhile: so none is long.
    private const int MaxWrite = 128 * 1024;

    // The numbers of these options where the framework's enumeration has no names for them.
    private const SocketOptionName KeepAliveTime = (SocketOptionName)3;
    private const SocketOptionName KeepAliveInterval = (SocketOptionName)17;
    private const SocketOptionName KeepAliveRetryCount = (SocketOptionName)16;

    private readonly int? _fragment;
    private readonly TimeSpan _closeTimeout;
    private readonly byte[] _buffer;
    private long _sent;
    private Task _drained = Task.CompletedTask;

    public TcpClientSession(Socket socket, FramePlan plan, FrameFeed feed, BroadcasterOptions options, Action<Recipient, Exception?> ended)
        : base(socket, socket.RemoteEndPoint, plan, feed, ended)
    {
        socket.NoDelay = true;
        socket.SendBufferSize = SendBufferSize;

        // A client that vanished without a word takes no more. The wait for room in the buffer ends only when about a third of it is free.
        socket.SendTimeout = (int)options.ClientTimeout.TotalMilliseconds;
        KeepAlive(socket);
        _fragment = options.Fragment;
        _closeTimeout = options.CloseTimeout;
        _buffer = new byte[ReadSize + (_fragment ?? 0)];
    }

    // Closing alone resets a connection in the middle of a write; this way the client reads what was sent and then sees the end.
    public override void Dispose()
    {
        try
        {
            Socket.Shutdown(SocketShutdown.Send);
        }
        catch (Exception exception) when (exception is SocketException or ObjectDisposedException)
        {
            // It was closed before, by either side.
        }

        base.Dispose();
    }

    protected override bool SendAll()
    {
        _drained = DrainAsync();
        int kept = 0;
        int read;
        while ((read = ReadFeed(_buffer.AsSpan(kept))) > 0)
        {
            int filled = kept + read;
            kept = Feed.IsLive || _fragment is null ? 0 : filled % _fragment.Value;
            if (!Write(filled - kept))
                return false;

            _buffer.AsSpan(filled - kept, kept).CopyTo(_buffer);
        }

        return Feed.IsAtEnd && Write(kept);
    }

    // The client sees the end of the stream after the last byte, and then has a while to take what is on its way and close its side.
    protected override void Finish()
    {
        Socket.Shutdown(SocketShutdown.Send);
        _drained.Wait(_closeTimeout);
    }

    // While nothing is sent, only a probe can find out that the client is gone: after 10 s, then every 2 s; given up after 5 without an answer.
    private static void KeepAlive(Socket socket)
    {
        try
        {
            socket.SetSocketOption(SocketOptionLevel.Socket, SocketOptionName.KeepAlive, optionValue: true);
            socket.SetSocketOption(SocketOptionLevel.Tcp, KeepAliveTime, 10);
            socket.SetSocketOption(SocketOptionLevel.Tcp, KeepAliveInterval, 2);
            socket.SetSocketOption(SocketOptionLevel.Tcp, KeepAliveRetryCount, 5);
        }
        catch (SocketException)
        {
            // Not every system has all of these; without them it takes longer.
        }
    }

    private bool Write(int count)
    {
        int offset = 0;
        while (offset < count)
        {
            int piece = Math.Min(count - offset, _fragment ?? MaxWrite);
            int sent = Socket.Send(_buffer, offset, piece, SocketFlags.None, out SocketError error);
            if (error is SocketError.TimedOut or SocketError.WouldBlock)
                DropUnsent();
            if (error != SocketError.Success)
                return false;

            offset += sent;
            _sent += sent;
            CountBytes(sent);
        }

        SetFrames(_sent / Plan.FrameSize * Plan.AvatarCount);
        return true;
    }

    // Nobody takes what is queued for a client that is let go; the system would keep it and go on trying. Closing now resets the connection.
    private void DropUnsent() => Socket.LingerState = new LingerOption(enable: true, seconds: 0);

    // Ends when the client has closed its sending side, which is no reason to stop sending to it, or when the connection is gone.
    private async Task DrainAsync()
    {
        byte[] scratch = new byte[512];
        try
        {
            while (await Socket.ReceiveAsync(scratch.AsMemory(), SocketFlags.None).ConfigureAwait(false) > 0)
            {
            }
        }
        catch (Exception exception) when (exception is SocketException or ObjectDisposedException or OutOfMemoryException)
        {
            // The next write reports it.
        }
    }
}
