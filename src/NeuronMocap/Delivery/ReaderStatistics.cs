using System.Diagnostics;

namespace NeuronMocap;

/// <summary>A snapshot of what a reader has received since it was made.</summary>
/// <remarks>
/// <para>Each figure is exact, but different figures may be read a moment apart.</para>
/// <para>
/// <see cref="PacketsReceived"/> counts every packet once. It is the sum of the three kinds of frames, <see cref="CommandPackets"/>,
/// <see cref="EmptyPackets"/> and <see cref="Undelivered"/>.
/// </para>
/// <para>
/// Every delivered frame is offered to every consumer. For a queue of all kinds, <see cref="FrameQueue.Delivered"/>, <see cref="FrameQueue.Dropped"/>,
/// <see cref="FrameQueue.Skipped"/> and <see cref="FrameQueue.Count"/> together equal the sum of the three kinds.
/// </para>
/// </remarks>
public readonly record struct ReaderStatistics
{
    /// <summary>Number of bytes of the stream that were delivered or skipped. An incomplete packet is not included.</summary>
    public long BytesReceived { get; init; }

    /// <summary>Number of delivered frames of all kinds: motion, calculation and Axis Studio's calculation.</summary>
    public long Frames => MotionFrames + CalculationFrames + StudioCalculationFrames;

    /// <summary>Number of complete packets in the stream. Packets that are not accepted count as <see cref="BytesSkipped"/> instead.</summary>
    public long PacketsReceived => Frames + CommandPackets + EmptyPackets + Undelivered;

    /// <summary>Number of delivered motion frames.</summary>
    public long MotionFrames { get; init; }

    /// <summary>Number of delivered calculation frames.</summary>
    public long CalculationFrames { get; init; }

    /// <summary>Number of delivered calculation frames of Axis Studio.</summary>
    public long StudioCalculationFrames { get; init; }

    /// <summary>Number of command packets of the old generation, which are recognized but not delivered as frames (protocol.md section 7).</summary>
    public long CommandPackets { get; init; }

    /// <summary>Number of packets without values, which are not delivered (protocol.md section 5).</summary>
    public long EmptyPackets { get; init; }

    /// <summary>Number of bytes outside packets.</summary>
    public long BytesSkipped { get; init; }

    /// <summary>Number of packets that announced more values than MaxValues allows. Their bytes are included in the skipped bytes.</summary>
    public long OversizedPackets { get; init; }

    /// <summary>Number of packets of a data version other than 1.0 and 1.1. Their bytes are included in the skipped bytes.</summary>
    public long UnknownVersionPackets { get; init; }

    /// <summary>
    /// Number of frames that the server sent but that did not arrive. It is the sum over all avatars, including those whose figures were
    /// removed to make room. See <see cref="AvatarStatistics.Lost"/>.
    /// </summary>
    public long Lost { get; init; }

    /// <summary>Number of gaps in the frame numbers: the sum over all avatars.</summary>
    public long Gaps { get; init; }

    /// <summary>How often the server restarted its frame count within a connection: the sum over all avatars.</summary>
    public long Restarts { get; init; }

    /// <summary>Number of received frames that were dropped because a queue was full: the sum over all queues, including closed queues.</summary>
    public long Dropped { get; init; }

    /// <summary>
    /// Number of received frames that consumers left out because of their MaxRate or EveryNth: the sum over all consumers, including closed ones. These
    /// frames are not lost.
    /// </summary>
    public long Skipped { get; init; }

    /// <summary>
    /// Number of packets that had arrived when the reader was stopped, but were no longer delivered. Over UDP, these include datagrams of a server that
    /// restarted less than a second before. Of the other figures, only <see cref="PacketsReceived"/> includes them. A recording contains them.
    /// </summary>
    public long Undelivered { get; init; }

    /// <summary>Number of exceptions from handlers, on the receive thread or during a change of status.</summary>
    public long CallbackFailures { get; init; }

    /// <summary>How often the reader connected again after its first connection ended; for UDP, how often it bound the port again.</summary>
    public long Reconnects { get; init; }

    /// <summary>The same as <see cref="Reconnects"/>, for the connection to CalculationPort; 0 if there is none.</summary>
    public long CalculationReconnects { get; init; }

    /// <summary>Number of datagrams from senders that AllowedSenders does not list. They are dropped unread and count nowhere else.</summary>
    public long RefusedDatagrams { get; init; }

    /// <summary>
    /// Number of datagrams and messages that the source did not understand: <c>VmcSource.Rejected</c>. They are dropped and count nowhere else. 0 for other
    /// sources and for connections.
    /// </summary>
    public long RejectedMessages { get; init; }

    /// <summary>When the first frame was received, in ticks of <see cref="Stopwatch"/>; 0 before the first frame.</summary>
    public long FirstFrameTimestamp { get; init; }

    /// <summary>When the newest frame was received, in ticks of <see cref="Stopwatch"/>; 0 before the first frame.</summary>
    public long LastFrameTimestamp { get; init; }

    /// <summary>Time from the first frame to the newest.</summary>
    public TimeSpan Duration => PreciseTime.FromSeconds((LastFrameTimestamp - FirstFrameTimestamp) / (double)Stopwatch.Frequency);
}
