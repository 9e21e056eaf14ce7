using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server.Clients;

/// <summary>One recipient of the broadcast: its socket, its feed, and the thread that writes the feed to the socket.</summary>
/// <remarks>
/// Writes block. A recipient that does not read blocks only its own thread. Closing the socket ends the thread at any point.
/// </remarks>
internal abstract class Recipient : IDisposable
{
    // A large buffer needs fewer system calls when a client is behind. It also limits the bytes in flight when a client vanishes.
    private const int BufferSize = 128 * 1024;

    private readonly Action<Recipient, Exception?> _ended;
    private Exception? _sourceError;
    private long _framesSent;
    private long _calculationFramesSent;
    private long _packetsLost;
    private long _bytesSent;
    private long _repliesSent;

    // ended is called once, on the recipient's thread, with the exception of a source if there was one.
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

    // Thread-safe.
    public RecipientCounters Counters => new(
        Interlocked.Read(ref _framesSent),
        Interlocked.Read(ref _calculationFramesSent),
        Interlocked.Read(ref _packetsLost) + Feed.MissedPackets,
        Interlocked.Read(ref _bytesSent),
        Interlocked.Read(ref _repliesSent),
        Commands?.Ignored ?? 0,
        Commands?.Dropped ?? 0);

    // The requests of the recipient. Null if it cannot send requests.
    protected DataCommandQueue? Commands { get; init; }

    protected Socket Socket { get; }

    protected BroadcastContent Plan => Stream.Content;

    protected FrameFeed Feed { get; }

    // Room for at least one frame.
    protected int ReadSize => Math.Max(BufferSize, Plan.MaxFrameSize);

    public virtual void Dispose() => Socket.Dispose();

    // For a recipient whose thread was never started and therefore does not close the feed.
    public void Discard()
    {
        Dispose();
        Feed.Close();
    }

    // Sends until the feed ends or the network fails. Returns true when everything was sent.
    protected abstract bool SendAll();

    // Called when everything was sent, before the socket is closed.
    protected virtual void Finish()
    {
    }

    // An exception of a source ends the broadcast. A lack of memory may hit this recipient's thread by chance, so it ends only this recipient.
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

    // For exception filters around calls of a source. Returns true unless memory ran out.
    protected bool IsOfSource(Exception exception)
    {
        if (exception is OutOfMemoryException)
            return false;

        _sourceError = exception;
        return true;
    }

    protected void CountBytes(int bytes) => Interlocked.Add(ref _bytesSent, bytes);

    // Sets the number of packets handed to the network so far.
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
            // The client disconnected or the broadcaster closed the socket. Both are ordinary ends of a connection. Or memory ran out.
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
