using System.Diagnostics;

namespace NeuronMocap;

/// <summary>
/// What a reader received since it was made, at the moment of asking. Each figure is exact; together they may be an instant apart.
/// <para>
/// Every packet has one fate: <see cref="PacketsReceived"/> is the sum of the three kinds of frames, <see cref="CommandPackets"/>,
/// <see cref="EmptyPackets"/> and <see cref="Undelivered"/>. A frame that is delivered goes to every consumer. A queue that gets all frames takes each of them:
/// <see cref="FrameQueue.Delivered"/>, <see cref="FrameQueue.Dropped"/> and <see cref="FrameQueue.Count"/> make up the sum of the three kinds.
/// </para>
/// </summary>
public readonly record struct ReaderStatistics
{
    /// <summary>Bytes of the stream that are accounted for: delivered or skipped. A packet that is not yet whole is not in it.</summary>
    public long BytesReceived { get; init; }

    /// <summary>Frames of every kind delivered: motion, calculation and Axis Studio's calculation.</summary>
    public long Frames => MotionFrames + CalculationFrames + StudioCalculationFrames;

    /// <summary>Whole packets found in the stream, whatever became of them. Packets that are not accepted are <see cref="BytesSkipped"/> instead.</summary>
    public long PacketsReceived => Frames + CommandPackets + EmptyPackets + Undelivered;

    /// <summary>Motion frames delivered.</summary>
    public long MotionFrames { get; init; }

    /// <summary>Calculation frames delivered.</summary>
    public long CalculationFrames { get; init; }

    /// <summary>Axis Studio's calculation frames delivered.</summary>
    public long StudioCalculationFrames { get; init; }

    /// <summary>Old-generation command packets, which are recognised and passed over (protocol.md section 7).</summary>
    public long CommandPackets { get; init; }

    /// <summary>Packets of no values, which are not delivered (protocol.md section 5).</summary>
    public long EmptyPackets { get; init; }

    /// <summary>Bytes that belong to no packet.</summary>
    public long BytesSkipped { get; init; }

    /// <summary>Packets that announced more values than MaxValues allows; their bytes are among the skipped ones.</summary>
    public long OversizedPackets { get; init; }

    /// <summary>Packets of a data version other than 1.0 and 1.1; their bytes are among the skipped ones.</summary>
    public long UnknownVersionPackets { get; init; }

    /// <summary>
    /// Frames that the server sent and that did not arrive: the sum over all avatars, with those whose figures made room for others. See
    /// <see cref="AvatarStatistics.Lost"/>.
    /// </summary>
    public long Lost { get; init; }

    /// <summary>Number of gaps that the lost frames left: the sum over all avatars.</summary>
    public long Gaps { get; init; }

    /// <summary>How often the server began to count frames anew within a connection: the sum over all avatars.</summary>
    public long Restarts { get; init; }

    /// <summary>Frames that arrived and found a queue full: the sum over all queues, closed ones included.</summary>
    public long Dropped { get; init; }

    /// <summary>
    /// Packets that had arrived when the reader was stopped, and were not delivered any more. Over UDP, datagrams of a server that restarted less than a second
    /// before are among them. Of the other figures only <see cref="PacketsReceived"/> counts them; a recording holds them.
    /// </summary>
    public long Undelivered { get; init; }

    /// <summary>Exceptions that handlers threw on the receive thread or while a status was told.</summary>
    public long CallbackFailures { get; init; }

    /// <summary>How often a connection stood again after the first one had ended; for UDP, how often the port was bound again.</summary>
    public long Reconnects { get; init; }

    /// <summary>As <see cref="Reconnects"/>, of the connection to CalculationPort; 0 where there is none.</summary>
    public long CalculationReconnects { get; init; }

    /// <summary>Datagrams of senders that AllowedSenders does not list. They were dropped unread and count nowhere else.</summary>
    public long RefusedDatagrams { get; init; }

    /// <summary>When the first frame was received: ticks of <see cref="Stopwatch"/>; 0 before.</summary>
    public long FirstFrameTimestamp { get; init; }

    /// <summary>When the newest frame was received: ticks of <see cref="Stopwatch"/>; 0 before.</summary>
    public long LastFrameTimestamp { get; init; }

    /// <summary>Time from the first frame to the newest.</summary>
    public TimeSpan Duration => TimeSpan.FromSeconds((LastFrameTimestamp - FirstFrameTimestamp) / (double)Stopwatch.Frequency);
}
