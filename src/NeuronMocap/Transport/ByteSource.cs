using NeuronMocap.Transport;

namespace NeuronMocap;

/// <summary>
/// Opens streams of bytes for a reader, in place of a network connection. Examples are a serial port, a tunnel, or the output of another
/// program. Derive from this class, and set <see cref="NeuronReaderOptions.Source"/>.
/// </summary>
/// <remarks>
/// The bytes are those that a server sends over TCP. A reader opens the source when it starts, and again after each end or failure, as
/// <see cref="NeuronReaderOptions.Reconnect"/> says. Several readers may use one source at the same time; each opens its own stream.
/// </remarks>
public abstract partial class ByteSource
{
    /// <summary>
    /// Name of the source in status messages, metrics and logs, such as "serial port COM3". The default is "the stream". A reader reads it once, when it
    /// is made, and refuses an empty name.
    /// </summary>
    public virtual string Name => "the stream";

    // What the source did not pass on because it cannot be right. Thread-safe.
    internal virtual long RejectedMessages => 0;

    // Whether another attempt can follow the end of the bytes.
    internal virtual bool CanReopen => true;

    // Called in place of the first opening if the reader ends before it begins.
    internal virtual void Discard()
    {
    }

    /// <summary>
    /// Opens a new stream. The reader calls this method on a thread of its own, so it may block. The reader disposes the stream when its bytes end, when
    /// reading fails, and when the reader stops.
    /// </summary>
    /// <remarks>
    /// An exception ends the attempt, and its message becomes part of the reader's status. To choose the reason too, throw a
    /// <see cref="NeuronConnectionException"/>.
    /// </remarks>
    /// <param name="cancellationToken">Cancelled when the reader stops. A stop does not wait for this method.</param>
    /// <returns>A readable stream. Its bytes do not continue those of an earlier stream.</returns>
    public abstract ValueTask<Stream> OpenAsync(CancellationToken cancellationToken);

    internal virtual async ValueTask<ByteReceiver> OpenReceiverAsync(ReceiveThread wanted, CancellationToken cancellationToken)
    {
        Stream stream = await OpenAsync(cancellationToken).ConfigureAwait(false) ?? throw new InvalidOperationException("The source returned no stream.");
        return ByteReceivers.Create(stream, leaveOpen: false, wanted);
    }
}
