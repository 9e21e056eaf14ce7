using System.Net;
using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server.Clients;

/// <summary>One recipient of the broadcast: its feed and its counters.</summary>
internal abstract class Recipient : IDisposable
{
    private Exception? _sourceError;
    private long _framesSent;
    private long _calculationFramesSent;
    private long _packetsLost;
    private long _bytesSent;
    private long _repliesSent;

    protected Recipient(BroadcastStream stream, FrameFeed feed, EndPoint? remoteEndPoint = null)
    {
        Stream = stream;
        Feed = feed;
        RemoteEndPoint = remoteEndPoint;
    }

    public EndPoint? RemoteEndPoint { get; }

    public BroadcastStream Stream { get; }

    // Whether every byte, up to the last frame, was handed over.
    public bool HadAll { get; protected set; }

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

    protected BroadcastContent Plan => Stream.Content;

    protected FrameFeed Feed { get; }

    // The exception of a source that ended the recipient; null if there was none.
    protected Exception? SourceError => _sourceError;

    // Called under the broadcaster's lock when the broadcast ends.
    public abstract void Stop();

    public abstract void Dispose();

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

    // Sets the number of packets handed over so far.
    protected void SetFrames(long motion, long calculation)
    {
        Interlocked.Exchange(ref _framesSent, motion);
        Interlocked.Exchange(ref _calculationFramesSent, calculation);
    }

    protected void CountReplies(int replies) => Interlocked.Add(ref _repliesSent, replies);

    protected void CountLostPacket() => Interlocked.Increment(ref _packetsLost);
}
