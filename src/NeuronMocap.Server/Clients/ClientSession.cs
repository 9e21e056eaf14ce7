using System.Net.Sockets;
using NeuronMocap.Protocol;
using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server.Clients;

/// <summary>The connection of a client. Clients need not send anything (protocol.md section 4.1).</summary>
/// <remarks>
/// Commands of clients are answered between whole packets (section 7), or passed to the server of a reader. Where the packets of a frame are sent one
/// by one, that can be in the middle of a frame. Everything that clients send is read. Closing a socket with unread bytes would reset the connection
/// and discard the client's last frames.
/// </remarks>
internal sealed partial class ClientSession : NetworkRecipient
{
    // Limits the data that the system buffers for a client that does not read. The default is megabytes, which hold a minute of old frames.
    public const int SendBufferSize = 256 * 1024;

    // The timeout of a write counts from its start, even while the client reads. Long writes are therefore avoided.
    private const int MaxWrite = 128 * 1024;

    // Limits the replies that are sent together, so that a client with very many requests still gets its frames.
    private const int MaxReplies = 64 * 1024;

    // Milliseconds.
    private const int PacketPause = 1;

    private readonly ClientTransport _transport;
    private readonly int? _fragment;
    private readonly bool _isPacketwise;
    private readonly TimeSpan _closeTimeout;
    private readonly DataCommandReplies? _replies;
    private readonly Queue<Milestone> _marks = new();

    // Whether the thread that publishes may send while this session's thread waits for a frame.
    private readonly bool _isDirect;

    private volatile bool _isDisposed;
    private byte[] _buffer;
    private long _sent;
    private long _motionSent;
    private long _calculationSent;

    public ClientSession(
        ClientTransport transport,
        BroadcastStream stream,
        FrameFeed feed,
        BroadcasterOptions options,
        Action<Recipient, Exception?> ended,
        FaultReport report)
        : base(transport.RemoteEndPoint, stream, feed, ended, report)
    {
        _transport = transport;
        _replies = stream.Replies;
        Commands = _replies is null ? null : new DataCommandQueue(_replies);
        _fragment = options.Fragment;
        _isPacketwise = stream.IsPacketwise && _fragment is null;
        _closeTimeout = options.CloseTimeout;
        _buffer = new byte[ReadSize + (_fragment ?? 0)];
        _isDirect = stream.IsDirect && _fragment is null && transport.TryStopWaiting();
        _rest = _isDirect ? new byte[Plan.MaxFrameSize] : [];
        if (_isDirect)
            feed.Attach(this);
        _listensHere = _isDirect && !feed.IsLive;
    }

    // Whether the client has closed its side. It may still read: a client that asks nothing can close its sending side.
    public bool IsLeft => _transport.IsLeft;

    // Whether the session is about to end.
    public bool IsDisposed => _isDisposed;

    // Thread-safe. Ends the session, also while its thread waits for a frame.
    public void Leave()
    {
        Dispose();
        Feed.Wake();
    }

    public override void Dispose()
    {
        _isDisposed = true;
        _transport.Dispose();
    }

    // Thread-safe. Called when a value has changed.
    public void Push(DataCommandId id, int avatar)
    {
        if (Commands?.Push(id, avatar) == true)
            Feed.Wake();
    }

    protected override bool SendAll()
    {
        BeginListening();
        int kept = 0;
        bool isOver;
        do
        {
            ListenNow();
            FrameBatch batch = ReadFeed(_buffer.AsSpan(kept, ReadSize));
            if (_isDisposed || !WriteRest())
                return false;

            isOver = batch.Bytes == 0 && Feed.HasEnded;
            int filled = AppendReplies(kept + batch.Bytes, out int replies);
            Mark(_sent + filled, batch, replies);
            kept = isOver || Feed.IsLive || _fragment is null ? 0 : filled % _fragment.Value;
            if (!Write(filled - kept, batch))
                return false;

            _buffer.AsSpan(filled - kept, kept).CopyTo(_buffer);
        }
        while (!isOver);

        return Feed.IsAtEnd;
    }

    // The client sees the end of the stream after the last byte. It then has some time to read the rest and close its side.
    protected override void Finish()
    {
        _transport.EndSending();
        FinishListening();
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

            if (!TrySend(_buffer, offset, end - offset, out int sent))
                return false;

            offset += sent;
        }

        CountWritten();
        return true;
    }

    // Waits until at least a part is sent. Returns false if the connection must be closed.
    private bool TrySend(byte[] bytes, int offset, int count, out int sent)
    {
        SocketError error = _listensHere ? TrySendSoon(bytes, offset, count, out sent) : _transport.TrySend(bytes, offset, count, out sent);
        if (error is SocketError.TimedOut or SocketError.WouldBlock)
            _transport.DropUnsent();
        if (error != SocketError.Success)
            return false;

        CountSent(sent);
        return true;
    }

    private void CountSent(int bytes)
    {
        _sent += bytes;
        CountBytes(bytes);
    }

    // A client that is only a little behind still gets packets one by one, because two packets in one write arrive together.
    private int NextPacket(int offset, in FrameBatch batch, int index)
    {
        if (index > 0 && batch.Packets <= Plan.PacketsPerFrame)
            Thread.Sleep(PacketPause);

        return Plan.MeasurePacket(_buffer.AsSpan(offset, batch.Bytes - offset), Plan.IsMotion(batch.First + index));
    }

    // Notes what has been sent when the stream reaches a position.
    private void Mark(long end, in FrameBatch batch, int replies = 0)
    {
        int motion = Plan.CountMotion(batch);
        _marks.Enqueue(new Milestone(end, motion, Plan.HasCalculation ? batch.Packets - motion : 0, replies));
    }

    private void CountWritten()
    {
        while (_marks.TryPeek(out Milestone mark) && mark.End <= _sent)
        {
            _marks.Dequeue();
            _motionSent += mark.Motion;
            _calculationSent += mark.Calculation;
            CountReplies(mark.Replies);
        }

        SetFrames(_motionSent, _calculationSent);
    }

    // The bytes read so far are whole packets, so a packet ends here. Returns where the bytes end.
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

    // The packets and replies put into the stream between the previous milestone and the position End.
    private readonly record struct Milestone(long End, int Motion, int Calculation, int Replies);
}
