using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server.Clients;

/// <summary>
/// One receiver of the broadcast: its socket, its feed, and the thread that carries bytes from the one to the other. The writes block: a
/// receiver that does not read stops its own thread and nothing else. Closing the socket ends the thread wherever it is.
/// </summary>
internal abstract class Recipient : IDisposable
{
    // Fewer system calls when a client is behind, and no more than this is under way when it vanishes.
    private const int BufferSize = 128 * 1024;

    private readonly Action<Recipient, Exception?> _ended;
    private Exception? _sourceError;
    private long _framesSent;
    private long _calculationFramesSent;
    private long _packetsLost;
    private long _bytesSent;
    private long _repliesSent;

    // Ended is called once, on the recipient's thread, with what a source threw if one did.
    protected Recipient(Socket socket, EndPoint? remoteEndPoint, BroadcastStream stream, FrameFeed feed, Action<Recipient, Exception?> ended, FaultReport report)
    {
        Socket = socket;
        RemoteEndPoint = remoteEndPoint;
        Stream = stream;
        Feed = feed;
        _ended = ended;
        Worker = new Worker("NeuronMocap recipient", Run, report);
    }

    public EndPoint? RemoteEndPoint { get; }

    public BroadcastStream Stream { get; }

    public Worker Worker { get; }

    // Whether every byte, up to the last frame, was handed to the network.
    public bool HadAll { get; private set; }

    // Safe on any thread.
    public RecipientCounters Counters => new(
        Interlocked.Read(ref _framesSent),
        Interlocked.Read(ref _calculationFramesSent),
        Interlocked.Read(ref _packetsLost) + Feed.MissedPackets,
        Interlocked.Read(ref _bytesSent),
        Interlocked.Read(ref _repliesSent),
        Commands?.Ignored ?? 0,
        Commands?.Dropped ?? 0);

    // What the receiver has asked for; null where it cannot ask.
    protected DataCommandQueue? Commands { get; init; }

    protected Socket Socket { get; }

    protected BroadcastContent Plan => Stream.Content;

    protected FrameFeed Feed { get; }

    // Room for at least one frame.
    protected int ReadSize => Math.Max(BufferSize, Plan.MaxFrameSize);

    public virtual void Dispose() => Socket.Dispose();

    // For one whose thread was never started, and so does not let go of the feed.
    public void Discard()
    {
        Dispose();
        Feed.Close();
    }

    // Sends until the feed ends or the network refuses; true when all was sent.
    protected abstract bool SendAll();

    // Called when all was sent, before the socket is closed.
    protected virtual void Finish()
    {
    }

    // What a source throws ends the broadcast; want of memory may have hit this receiver's thread by chance, and ends this receiver.
    protected FrameBatch ReadFeed(Span<byte> destination)
    {
        try
        {
            return Feed.Read(destination);
        }
        catch (Exception exception) when (IsOfSource(exception))
        {
            throw;
        }
    }

    // For filters of code that asks a source; true, unless memory is short.
    protected bool IsOfSource(Exception exception)
    {
        if (exception is OutOfMemoryException)
            return false;

        _sourceError = exception;
        return true;
    }

    protected void CountBytes(int bytes) => Interlocked.Add(ref _bytesSent, bytes);

    // Packets handed to the network so far.
    protected void SetFrames(long motion, long calculation)
    {
        Interlocked.Exchange(ref _framesSent, motion);
        Interlocked.Exchange(ref _calculationFramesSent, calculation);
    }

    protected void CountReplies(int replies) => Interlocked.Add(ref _repliesSent, replies);

    protected void CountLostPacket() => Interlocked.Increment(ref _packetsLost);

    private void Run()
    {
        Exception? error;
        try
        {
            HadAll = SendAll();
            if (HadAll)
                Finish();
            error = null;
        }
        catch (Exception exception) when (exception is SocketException or ObjectDisposedException or OutOfMemoryException)
        {
            // The client went away or the broadcaster closed the socket: the ordinary ends of a connection. Or there was no memory for it.
            error = _sourceError;
        }
        catch (Exception exception)
        {
            error = exception;
        }

        Dispose();
        Feed.Close();
        _ended(this, error);
    }
}
