using System.Runtime.CompilerServices;
using NeuronMocap.Protocol;

namespace NeuronMocap.Delivery;

// Counts all received packets and bytes in one place. Every complete packet is delivered as a frame, skipped because it has no values, or undelivered
// because the reader was stopped. Every other byte is skipped, or is text between frames. Each consumer counts its dropped and skipped frames, and Consumers sums them up.
// The receive thread writes, any thread reads; comments mark the members that other threads write too.
internal sealed class StreamCounters(IDurationRecorder? intervals = null)
{
    private readonly long[] _skippedByReason = new long[(int)SkipReason.MissingAvatar + 1];
    private readonly AvatarTrackers _avatars = new(intervals);
    private long _bytes;
    private long _motionFrames;
    private long _calculationFrames;
    private long _studioFrames;
    private long _commandPackets;
    private long _emptyPackets;
    private long _bytesSkipped;
    private long _oversizedPackets;
    private long _unknownVersions;
    private long _connections;
    private long _calculationConnections;
    private long _firstFrame;
    private long _lastFrame;
    private long _undelivered;
    private long _callbackFailures;

    public AvatarTracker[] Trackers => _avatars.All;

    public ConsumerCounters Consumers { get; } = new();

    // Number of bytes skipped for this reason.
    public long GetSkipped(SkipReason reason) => Volatile.Read(ref _skippedByReason[(int)reason]);

    // A new connection is established. The connection to a calculation port brings no motion. If there was one, the first connection brings only motion.
    public void Resume(bool isCalculation = false)
    {
        if (isCalculation)
            Volatile.Write(ref _calculationConnections, _calculationConnections + 1);
        else
            Volatile.Write(ref _connections, _connections + 1);

        foreach (AvatarTracker tracker in _avatars.All)
        {
            bool isItsOwn = tracker.Kind == PacketKind.Motion ? !isCalculation : isCalculation || _calculationConnections == 0;
            if (isItsOwn)
                tracker.Resume();
        }
    }

    // Counts a found packet before it is delivered.
    public void Count(in ReceivedPacket packet)
    {
        if (packet.IsFrame)
            CountFrame(packet);
        else
            CountPassedOver(packet);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void CountFrame(in ReceivedPacket packet)
    {
        if (packet.Kind == PacketKind.Motion)
            CountMotion(packet);
        else
            CountCalculation(packet);
    }

    public void CountPassedOver(in ReceivedPacket packet)
    {
        if (packet.Kind == PacketKind.Command)
            Volatile.Write(ref _commandPackets, _commandPackets + 1);
        else
            Volatile.Write(ref _emptyPackets, _emptyPackets + 1);

        Volatile.Write(ref _bytes, _bytes + packet.Length);
    }

    // Counts a packet that was found after the reader was stopped. Any thread.
    public void CountUndelivered() => Interlocked.Increment(ref _undelivered);

    // Any thread.
    public void CountCallbackFailure() => Interlocked.Increment(ref _callbackFailures);

    // Counts bytes of the text stream, as received.
    public void CountText(int bytes) => Volatile.Write(ref _bytes, _bytes + bytes);

    public void CountSkipped(int bytes, SkipReason reason)
    {
        Volatile.Write(ref _bytesSkipped, _bytesSkipped + bytes);
        Volatile.Write(ref _skippedByReason[(int)reason], _skippedByReason[(int)reason] + bytes);
        Volatile.Write(ref _bytes, _bytes + bytes);
        if (reason == SkipReason.TooLarge)
            Volatile.Write(ref _oversizedPackets, _oversizedPackets + 1);
        else if (reason == SkipReason.UnknownVersion)
            Volatile.Write(ref _unknownVersions, _unknownVersions + 1);
    }

    // Some programs call this in every rendered frame, so it allocates nothing.
    public ReaderStatistics Snapshot()
    {
        LossTotals total = default;
        foreach (AvatarTracker tracker in _avatars.All)
            total = total.Add(tracker.Totals);

        (long dropped, long skipped) = Consumers.Sum;
        return new ReaderStatistics
        {
            BytesReceived = Volatile.Read(ref _bytes),
            MotionFrames = Volatile.Read(ref _motionFrames),
            CalculationFrames = Volatile.Read(ref _calculationFrames),
            StudioCalculationFrames = Volatile.Read(ref _studioFrames),
            CommandPackets = Volatile.Read(ref _commandPackets),
            Undelivered = Volatile.Read(ref _undelivered),
            CallbackFailures = Volatile.Read(ref _callbackFailures),
            Dropped = dropped,
            Skipped = skipped,
            EmptyPackets = Volatile.Read(ref _emptyPackets),
            BytesSkipped = Volatile.Read(ref _bytesSkipped),
            OversizedPackets = Volatile.Read(ref _oversizedPackets),
            UnknownVersionPackets = Volatile.Read(ref _unknownVersions),
            Reconnects = Math.Max(0, Volatile.Read(ref _connections) - 1),
            CalculationReconnects = Math.Max(0, Volatile.Read(ref _calculationConnections) - 1),
            FirstFrameTimestamp = Volatile.Read(ref _firstFrame),
            LastFrameTimestamp = Volatile.Read(ref _lastFrame),
            Lost = total.Lost,
            Gaps = total.Gaps,
            Restarts = total.Restarts,
        };
    }

    private void CountMotion(in ReceivedPacket packet)
    {
        ReadOnlySpan<byte> header = packet.Header;
        Volatile.Write(ref _motionFrames, _motionFrames + 1);
        CountBytes(packet);
        _avatars.Find(packet, MotionHeader.ReadAvatarIndex(header))
            ?.OnFrame(MotionHeader.AvatarNameIn(header), MotionHeader.ReadFrameIndex(header), packet.Timestamp);
    }

    // Counts a calculation frame of Axis Neuron or Axis Studio; both headers have these fields in the same places.
    private void CountCalculation(in ReceivedPacket packet)
    {
        ReadOnlySpan<byte> header = packet.Header;
        if (packet.Kind == PacketKind.Calculation)
            Volatile.Write(ref _calculationFrames, _calculationFrames + 1);
        else
            Volatile.Write(ref _studioFrames, _studioFrames + 1);

        CountBytes(packet);
        _avatars.Find(packet, CalculationHeader.ReadAvatarIndex(header))
            ?.OnFrame(CalculationHeader.AvatarNameIn(header), CalculationHeader.ReadFrameIndex(header), packet.Timestamp);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void CountBytes(in ReceivedPacket packet)
    {
        if (!packet.IsText)
            Volatile.Write(ref _bytes, _bytes + packet.Length);

        // Datagrams that waited until their sender was identified are delivered with the time of their arrival, up to a second late.
        if (packet.Timestamp > _lastFrame)
            Volatile.Write(ref _lastFrame, packet.Timestamp);
        if (_firstFrame == 0)
            Volatile.Write(ref _firstFrame, packet.Timestamp);
    }
}
