using System.Diagnostics;
using System.Diagnostics.CodeAnalysis;
using NeuronMocap.Delivery;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;

namespace NeuronMocap;

/// <summary>
/// The newest frame of every avatar, for one thread of the application. It suits a renderer, which does not need older frames.
/// </summary>
/// <remarks>
/// <para>
/// Neither the receive thread nor the application ever waits. Frames are never torn and never queued. A newer frame replaces a frame that was not taken.
/// </para>
/// <para>
/// The view keeps frames of avatar numbers below <see cref="MaxAvatars"/>, from any sender. It allocates memory when an avatar first appears.
/// </para>
/// </remarks>
public sealed class LatestFrames : IPacketConsumer, ICountedConsumer, IDisposable
{
    internal const string MetricName = "latest";

    /// <summary>Number of avatars that the view keeps, from 0. Frames of higher avatar numbers are not available here.</summary>
    public const int MaxAvatars = 256;

    private readonly FrameFormat _format;
    private readonly Action<LatestFrames> _closed;
    private readonly IDurationRecorder? _handOver;
    private readonly FrameThinner? _thinner;

    // The slots of one kind of frame lie together.
    private readonly Slot?[] _slots = new Slot?[((int)PacketKind.StudioCalculation + 1) * MaxAvatars];
    private volatile bool _disposed;

    internal LatestFrames(FrameFormat format, Action<LatestFrames> closed, IDurationRecorder? handOver = null, FrameThinner? thinner = null)
    {
        _format = format;
        _closed = closed;
        _handOver = handOver;
        _thinner = thinner;
    }

    /// <summary>
    /// Number of frames that were never shown because of <see cref="LatestFramesOptions.MaxRate"/> or <see cref="LatestFramesOptions.EveryNth"/>. Frames
    /// that a newer frame replaced are not included. Thread-safe.
    /// </summary>
    public long Skipped => _thinner?.Skipped ?? 0;

    string ICountedConsumer.Name => MetricName;

    long ICountedConsumer.Dropped => 0;

    int ICountedConsumer.Count => 0;

    /// <summary>Takes the newest motion frame of an avatar, if it was not taken before.</summary>
    /// <param name="avatarIndex">Number of the avatar, from 0.</param>
    /// <param name="frame">
    /// The avatar's newest frame, even if it was taken before; null until the first frame arrives. One thread may use it until this method next returns
    /// true for the same avatar; its members then throw. <c>Clone</c> makes a copy to keep.
    /// </param>
    /// <returns>True when the frame is new since the last call.</returns>
    public bool TryTakeMotion(int avatarIndex, [NotNullWhen(true)] out MotionFrame? frame)
    {
        bool isNew = TryTake(PacketKind.Motion, avatarIndex, out AvatarFrame? newest);
        frame = (MotionFrame?)newest;
        return isNew;
    }

    /// <summary>Takes the newest calculation frame of an avatar, if it was not taken before.</summary>
    /// <param name="avatarIndex">Number of the avatar, from 0.</param>
    /// <param name="frame">As for <see cref="TryTakeMotion"/>.</param>
    /// <returns>True when the frame is new since the last call.</returns>
    public bool TryTakeCalculation(int avatarIndex, [NotNullWhen(true)] out CalculationFrame? frame)
    {
        bool isNew = TryTake(PacketKind.Calculation, avatarIndex, out AvatarFrame? newest);
        frame = (CalculationFrame?)newest;
        return isNew;
    }

    /// <summary>Takes the newest Axis Studio calculation frame of an avatar, if it was not taken before.</summary>
    /// <param name="avatarIndex">Number of the avatar, from 0.</param>
    /// <param name="frame">As for <see cref="TryTakeMotion"/>.</param>
    /// <returns>True when the frame is new since the last call.</returns>
    public bool TryTakeStudioCalculation(int avatarIndex, [NotNullWhen(true)] out StudioCalculationFrame? frame)
    {
        bool isNew = TryTake(PacketKind.StudioCalculation, avatarIndex, out AvatarFrame? newest);
        frame = (StudioCalculationFrame?)newest;
        return isNew;
    }

    /// <summary>Removes this view from its reader. Any thread, any number of times.</summary>
    public void Dispose()
    {
        if (_disposed)
            return;

        _disposed = true;
        _closed(this);
    }

    void ICountedConsumer.CompleteAdding()
    {
    }

    void IPacketConsumer.OnPacket(in ReceivedPacket packet)
    {
        uint avatarIndex = packet.AvatarIndex;
        if (avatarIndex >= MaxAvatars || (_thinner is { } thinner && !thinner.Takes(packet)))
            return;

        ref Slot? place = ref _slots[PlaceOf(packet.Kind, (int)avatarIndex)];
        if (place is { } slot)
        {
            slot.Newest.Publish(packet);
            return;
        }

        slot = new Slot(_format, packet.Length);
        slot.Newest.Publish(packet);
        Volatile.Write(ref place, slot);
    }

    private static int PlaceOf(PacketKind kind, int avatarIndex) => ((int)kind * MaxAvatars) + avatarIndex;

    // Not generic: code that generic arguments share calls the runtime for each cast.
    private bool TryTake(PacketKind kind, int avatarIndex, [NotNullWhen(true)] out AvatarFrame? frame)
    {
        Slot? slot = (uint)avatarIndex < MaxAvatars ? Volatile.Read(ref _slots[PlaceOf(kind, avatarIndex)]) : null;
        frame = slot?.Frame;
        if (slot is null || !slot.Newest.TryTake(out ReceivedPacket packet))
            return false;

        if (_handOver is { IsEnabled: true })
            _handOver.Record(packet.Kind, Stopwatch.GetTimestamp() - packet.Timestamp);

        frame = slot.Show(packet);
        return true;
    }

    private sealed class Slot(FrameFormat format, int packetSize)
    {
        private readonly FramePool _frames = new(format, FramePool.OfTakers);

        // The consumer's frame, which borrows the slot that the consumer holds.
        public AvatarFrame? Frame { get; private set; }

        public LatestPacket Newest { get; } = new(packetSize);

        public AvatarFrame Show(in ReceivedPacket packet)
        {
            Frame?.Expire();
            return Frame = _frames.Lend(packet);
        }
    }
}
