using System.Net.Sockets;
using NeuronMocap.Protocol;
using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Transport;

namespace NeuronMocap.Server.Clients;

/// <summary>
/// A client's connection. Clients need not send anything (protocol.md section 4.1). The commands that they may send are answered between whole
/// packets (section 7), in the middle of a frame too where its packets are sent one by one. Whatever they send is read, because a socket that is
/// closed over unread bytes resets the connection and takes the client's last frames with it.
/// </summary>
internal sealed class TcpClientSession : Recipient
{
    // Bounds what the system keeps for a client that does not read. By default it is megabytes, which is a minute of old frames.
    private const int SendBufferSize = 256 * 1024;

    // The time limit of a write counts from its begin, however much the client takes meanwhile: so none is long.
    private const int MaxWrite = 128 * 1024;

    // Replies in one go, so that a client that asks for very much still gets its frames.
    private const int MaxReplies = 64 * 1024;

    // Between two looks at what a client asks. A flood of requests wakes nobody more often, and waits in the client's own connection.
    private const int ListeningPause = 10;

    // Milliseconds.
    private const int PacketPause = 1;

    private readonly int? _fragment;
    private readonly bool _isPacketwise;
    private readonly TimeSpan _closeTimeout;
    private readonly DataCommandReplies? _replies;
    private readonly Queue<Mark> _marks = new();
    private byte[] _buffer;
    private long _sent;
    private long _motionSent;
    private long _calculationSent;
    private Task _listened = Task.CompletedTask;
    private volatile bool _isFinishing;

    public TcpClientSession(
        Socket socket,
        BroadcastStream stream,
        FrameFeed feed,
        BroadcasterOptions options,
        Action<Recipient, Exception?> ended,
        FaultReport report)
        : base(socket, socket.RemoteEndPoint, stream, feed, ended, report)
    {
        _replies = stream.Replies;
        Commands = _replies is null ? null : new DataCommandQueue(_replies);
        socket.NoDelay = true;
        socket.SendBufferSize = SendBufferSize;

        // A client that vanished without a word takes no more. The wait for room in the buffer ends only when about a third of it is free.
        socket.SendTimeout = (int)options.ClientTimeout.TotalMilliseconds;
        // While nothing is sent, only a probe can find out that the client is gone.
        TcpKeepAlive.Enable(socket);
        _fragment = options.Fragment;
        _isPacketwise = stream.IsPacketwise && _fragment is null;
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

    // Any thread: a value has changed.
    public void Push(DataCommandId id, int avatar)
    {
        if (Commands?.Push(id, avatar) == true)
            Feed.Wake();
    }

    protected override bool SendAll()
    {
        _listened = ListenAsync();
        int kept = 0;
        bool isOver;
        do
        {
            FrameBatch batch = ReadFeed(_buffer.AsSpan(kept, ReadSize));
            isOver = batch.Bytes == 0 && Feed.HasEnded;
            int filled = AppendReplies(kept + batch.Bytes, out int replies);
            int motion = Plan.CountMotion(batch);
            _marks.Enqueue(new Mark(_sent + filled, motion, Plan.HasCalculation ? batch.Packets - motion : 0, replies));
            kept = isOver || Feed.IsLive || _fragment is null ? 0 : filled % _fragment.Value;
            if (!Write(filled - kept, batch))
                return false;

            _buffer.AsSpan(filled - kept, kept).CopyTo(_buffer);
        }
        while (!isOver);

        return Feed.IsAtEnd;
    }

    // The client sees the end of the stream after the last byte, and then has a while to take what is on its way and close its side.
    protected override void Finish()
    {
        _isFinishing = true;
        Socket.Shutdown(SocketShutdown.Send);
        _listened.Wait(_closeTimeout);
    }

    private bool Write(int count, in FrameBatch batch)
    {
        int offset = 0;
        int end = 0;
        int packets = 0;
        while (offset < count)
        {
            if (offset == end)
                end = offset + (_isPacketwise && packets < batch.Packets ? NextPacket(offset, batch, packets++) : Math.Min(count - offset, _fragment ?? MaxWrite));

            int sent = Socket.Send(_buffer, offset, end - offset, SocketFlags.None, out SocketError error);
            if (error is SocketError.TimedOut or SocketError.WouldBlock)
                DropUnsent();
            if (error != SocketError.Success)
                return false;

            offset += sent;
            _sent += sent;
            CountBytes(sent);
        }

        CountWritten();
        return true;
    }

    // A reader that is only a little behind still gets packets one by one: two that are written at once arrive at once.
    private int NextPacket(int offset, in FrameBatch batch, int index)
    {
        if (index > 0 && batch.Packets <= Plan.PacketsPerFrame)
            Thread.Sleep(PacketPause);

        return Plan.MeasurePacket(_buffer.AsSpan(offset, batch.Bytes - offset), Plan.IsMotion(batch.First + index));
    }

    private void CountWritten()
    {
        while (_marks.TryPeek(out Mark mark) && mark.End <= _sent)
        {
            _marks.Dequeue();
            _motionSent += mark.Motion;
            _calculationSent += mark.Calculation;
            CountReplies(mark.Replies);
        }

        SetFrames(_motionSent, _calculationSent);
    }

    // What was read is whole packets, so here ends one. Returns where the bytes end.
    private int AppendReplies(int filled, out int count)
    {
        count = 0;
        if (_replies is null)
            return filled;

        int limit = filled + MaxReplies;
        try
        {
            while (filled < limit && Commands!.TryTake(out DataCommandId id, out int avatar))
            {
                int size = _replies.Measure(id, avatar);
                if (_buffer.Length - filled < size)
                    Array.Resize(ref _buffer, Math.Max(limit, filled + size));

                _replies.Write(id, avatar, _buffer.AsSpan(filled));
                filled += size;
                count++;
            }
        }
        catch (Exception exception) when (IsOfSource(exception))
        {
            throw;
        }

        if (!Commands!.IsEmpty)
            Feed.Wake();

        return filled;
    }

    // Nobody takes what is queued for a client that is let go; the system would keep it and go on trying. Closing now resets the connection.
    private void DropUnsent() => Socket.LingerState = new LingerOption(enable: true, seconds: 0);

    // Ends when the client has closed its sending side, which is no reason to stop sending to it, or when the connection is gone.
    private async Task ListenAsync()
    {
        var scanner = new RequestScanner();
        try
        {
            int read;
            while ((read = await Socket.ReceiveAsync(scanner.Room, SocketFlags.None).ConfigureAwait(false)) > 0)
            {
                scanner.Advance(read);
                bool hasReplies = false;
                while (scanner.TryRead(out DataCommandHeader request))
                    hasReplies |= Commands?.Accept(request) ?? false;

                if (!hasReplies)
                    continue;

                Feed.Wake();
                if (!_isFinishing)
                    await Task.Delay(ListeningPause).ConfigureAwait(false);
            }
        }
        catch (Exception exception) when (exception is SocketException or ObjectDisposedException or OutOfMemoryException)
        {
            // The next write reports it.
        }
    }

    // What was put into the stream up to a place, since the mark before.
    private readonly record struct Mark(long End, int Motion, int Calculation, int Replies);
}
