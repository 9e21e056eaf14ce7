using System.Diagnostics;
using System.Diagnostics.CodeAnalysis;
using NeuronMocap.Delivery;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;

namespace NeuronMocap;

/// <summary>
/// The newest frame of every avatar, for one thread of the application: what a renderer wants, which has no use for older frames.
/// Neither side ever waits, frames are never torn and never queued; a frame that a newer one replaced before it was taken is gone, on purpose.
/// <para>
/// Kept for avatar numbers below <see cref="MaxAvatars"/>, whichever sender they come from. Memory is allocated when an avatar
/// first appears.
/// </para>
/// </summary>
public sealed class LatestFrames : IPacketConsumer, IDisposable
{
    /// <summary>Number of avatars that are kept apart, from 0; frames of higher numbers do not appear here.</summary>
    public const int MaxAvatars = 256;

    private readonly FrameFormat _format;
    private readonly Action<LatestFrames> _closed;
    private readonly IDurationRecorder? _handOver;
    private readonly Slot<MotionFrame>?[] _motion = new Slot<MotionFrame>?[MaxAvatars];
    private readonly Slot<CalculationFrame>?[] _calculation = new Slot<CalculationFrame>?[MaxAvatars];
    private readonly Slot<StudioCalculationFrame>?[] _studio = new Slot<StudioCalculationFrame>?[MaxAvatars];
    private volatile bool _disposed;

    internal LatestFrames(FrameFormat format, Action<LatestFrames> closed, IDurationRecorder? handOver = null)
    {
        _format = format;
        _closed = closed;
        _handOver = handOver;
    }

    /// <summary>Takes the newest motion frame of an avatar, when there is one that was not taken before.</summary>
    /// <param name="avatar">Number of the avatar, from 0.</param>
    /// <param name="frame">
    /// The avatar's newest frame, also when it was taken before; null as long as there was none. Valid, for one thread, until this method
    /// next returns true for the same avatar; its members then throw. <c>Clone</c> makes one to keep.
    /// </param>
    /// <returns>True when the frame is new since the last call.</returns>
    public bool TryTakeMotion(int avatar, [NotNullWhen(true)] out MotionFrame? frame) => TryTake(_motion, avatar, out frame);

    /// <summary>Takes the newest calculation frame of an avatar, when there is one that was not taken before.</summary>
    /// <param name="avatar">Number of the avatar, from 0.</param>
    /// <param name="frame">As for <see cref="TryTakeMotion"/>.</param>
    /// <returns>True when the frame is new since the last call.</returns>
    public bool TryTakeCalculation(int avatar, [NotNullWhen(true)] out CalculationFrame? frame) => TryTake(_calculation, avatar, out frame);

    /// <summary>Takes the newest of an avatar's Axis Studio calculation frames, when there is one that was not taken before.</summary>
    /// <param name="avatar">Number of the avatar, from 0.</param>
    /// <param name="frame">As for <see cref="TryTakeMotion"/>.</param>
    /// <returns>True when the frame is new since the last call.</returns>
    public bool TryTakeStudioCalculation(int avatar, [NotNullWhen(true)] out StudioCalculationFrame? frame) => TryTake(_studio, avatar, out frame);

    /// <summary>Takes this view off its reader. Any thread, any number of times.</summary>
    public void Dispose()
    {
        if (_disposed)
            return;

        _disposed = true;
        _closed(this);
    }

    void IPacketConsumer.OnPacket(in ReceivedPacket packet)
    {
        if (packet.Kind == PacketKind.Motion)
            Publish(_motion, MotionHeader.ReadAvatarIndex(packet.Bytes), packet, _format, static format => new LentFrames<MotionFrame>(() => new MotionFrame(format), LentFrames<MotionFrame>.OfTakers));
        else if (packet.Kind == PacketKind.Calculation)
            Publish(_calculation, CalculationHeader.ReadAvatarIndex(packet.Bytes), packet, _format, static _ => new LentFrames<CalculationFrame>(static () => new CalculationFrame(), LentFrames<CalculationFrame>.OfTakers));
        else
            Publish(_studio, StudioCalculationHeader.ReadAvatarIndex(packet.Bytes), packet, _format, static _ => new LentFrames<StudioCalculationFrame>(static () => new StudioCalculationFrame(), LentFrames<StudioCalculationFrame>.OfTakers));
    }

    private static void Publish<TFrame>(
        Slot<TFrame>?[] slots, uint avatar, in ReceivedPacket packet, FrameFormat format, Func<FrameFormat, LentFrames<TFrame>> create)
        where TFrame : AvatarFrame
    {
        if (avatar >= MaxAvatars)
            return;

        Slot<TFrame>? slot = slots[avatar];
        if (slot is null)
        {
            slot = new Slot<TFrame>(create(format), packet.Length);
            slot.Newest.Publish(packet);
            Volatile.Write(ref slots[avatar], slot);
            return;
        }

        slot.Newest.Publish(packet);
    }

    private bool TryTake<TFrame>(Slot<TFrame>?[] slots, int avatar, [NotNullWhen(true)] out TFrame? frame)
        where TFrame : AvatarFrame
    {
        Slot<TFrame>? slot = (uint)avatar < MaxAvatars ? Volatile.Read(ref slots[avatar]) : null;
        frame = slot?.Frame;
        if (slot is null || !slot.Newest.TryTake(out ReceivedPacket packet))
            return false;

        if (_handOver is { IsEnabled: true })
            _handOver.Record(packet.Kind, Stopwatch.GetTimestamp() - packet.Timestamp);

        frame = slot.Show(packet);
        return true;
    }

    private sealed class Slot<TFrame>(LentFrames<TFrame> frames, int packetSize)
        where TFrame : AvatarFrame
    {
        // The consumer's; it borrows the slot that the consumer holds.
        public TFrame? Frame { get; private set; }

        public NewestPacket Newest { get; } = new(packetSize);

        public TFrame Show(in ReceivedPacket packet)
        {
            Frame?.Expire();
            return Frame = frames.Lend(packet);
        }
    }
}
