using System.Net;
using System.Net.Sockets;
using NeuronMocap.Server.Broadcasting;

namespace NeuronMocap.Server.Clients;

/// <summary>A recipient on the network, and the thread that writes the feed to it.</summary>
/// <remarks>
/// Writes block. A recipient that does not read blocks only its own thread. Disposing it ends the thread at any point.
/// </remarks>
internal abstract class NetworkRecipient : Recipient
{
    // A large buffer needs fewer system calls when a client is behind. It also limits the bytes in flight when a client vanishes.
    private const int BufferSize = 128 * 1024;

    private readonly Action<Recipient, Exception?> _ended;

    // ended is called once, on the recipient's thread, with the exception of a source if there was one.
    protected NetworkRecipient(EndPoint? remoteEndPoint, BroadcastStream stream, FrameFeed feed, Action<Recipient, Exception?> ended, FaultReport report)
        : base(stream, feed, remoteEndPoint)
    {
        _ended = ended;
        Worker = new Worker("NeuronMocap recipient", Run, report);
    }

    public Worker Worker { get; }

    // Room for at least one frame.
    protected int ReadSize => Math.Max(BufferSize, Plan.MaxFrameSize);

    public override void Stop()
    {
        if (Worker.IsStarted)
            Dispose();
        else
            Discard();
    }

    // For a recipient whose thread was never started and therefore does not close the feed.
    public void Discard()
    {
        Dispose();
        Feed.Close();
    }

    // Sends until the feed ends or the network fails. Returns true when everything was sent.
    protected abstract bool SendAll();

    // Called when everything was sent, before the recipient is disposed.
    protected virtual void Finish()
    {
    }

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
            error = SourceError;
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
