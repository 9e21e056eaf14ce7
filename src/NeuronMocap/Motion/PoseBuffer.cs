using NeuronMocap.Skeleton;

namespace NeuronMocap.Motion;

/// <summary>
/// Converts frames that arrive at uneven times to poses at the times of another clock, such as that of a display: a jitter buffer.
/// </summary>
/// <remarks>
/// <para>
/// The buffer reconstructs the sender's even clock from the arrivals. It interpolates the pose at any time on that clock, a chosen delay in the
/// past. If no frame arrives in time, the motion continues for a short while and then stops.
/// </para>
/// <para>
/// The buffer handles frames that are late, duplicate, missing or bundled, a change of the frame rate, and a counter that restarts.
/// </para>
/// <para>
/// One thread pushes, usually the receive thread, and one thread samples. Neither waits for the other, and a pose never mixes parts of two pushed
/// frames. After the constructor, nothing is allocated. Use one buffer for each avatar.
/// </para>
/// </remarks>
public sealed class PoseBuffer
{
    private readonly double _delay;
    private readonly PoseRing _ring;
    private readonly SenderClock _clock = new();
    private readonly PoseTimeline _timeline;

    private long _dropped;
    private int _taken;

    /// <summary>Creates a buffer.</summary>
    /// <param name="options">The delay and limits; null for the defaults.</param>
    /// <exception cref="ArgumentOutOfRangeException">An option is out of range.</exception>
    public PoseBuffer(PoseBufferOptions? options = null)
    {
        options = PoseBufferOptions.CopyChecked(options);
        _delay = options.Delay.TotalSeconds;
        _ring = new PoseRing(options.Capacity);
        _timeline = new PoseTimeline(options, _ring.Capacity);
    }

    /// <summary>
    /// Number of frames dropped because the buffer was full. Either no thread sampled for a long time, or the delay is too long for the capacity.
    /// Thread-safe.
    /// </summary>
    public long Dropped => Interlocked.Read(ref _dropped);

    /// <summary>
    /// Seconds from one received frame to the next on the sender's clock, averaged over the latest frames; 0 until known. Read it on the sampling
    /// thread.
    /// </summary>
    public double FrameInterval => _clock.Interval;

    /// <summary>
    /// Mean deviation of arrivals from the sender's even clock, in seconds. A delay of one frame plus four times this value is rarely too short.
    /// Read it on the sampling thread.
    /// </summary>
    public double Jitter => _clock.Jitter;

    /// <summary>
    /// The tag of the frame whose pose the latest <see cref="Sample"/> returned: of the earlier one, if the pose lies between two frames. Use it for data
    /// that belongs to frames, such as foot contacts. Read it on the sampling thread.
    /// </summary>
    public long SampledTag => _timeline.SampledTag;

    /// <summary>
    /// Number of frames that arrived after the time at which they were to be shown. Too many of them mean that the delay is too short. Read it on the
    /// sampling thread.
    /// </summary>
    public long Late { get; private set; }

    /// <summary>
    /// Adds a frame. Call it from one thread, which may be the thread of <see cref="Sample"/>. It never waits and does not allocate memory.
    /// </summary>
    /// <param name="pose">
    /// 59 transforms relative to their parents, in <see cref="Bone"/> order; copied. Transforms relative to a moving Reference node are not
    /// converted to the world.
    /// </param>
    /// <param name="arrivalSeconds">The receive time of the frame, on the clock of <see cref="Sample"/>.</param>
    /// <param name="frameIndex">The sender's counter, if available. It reveals missing, duplicate and reordered frames.</param>
    /// <param name="tag">A number of your own for the frame, which <see cref="SampledTag"/> returns.</param>
    /// <returns>True if the frame was added. False if the buffer was full or the time is not finite: the frame is dropped and counted.</returns>
    /// <exception cref="ArgumentException">There are fewer than 59 transforms.</exception>
    public bool Push(ReadOnlySpan<BoneTransform> pose, double arrivalSeconds, uint? frameIndex = null, long tag = 0)
    {
        ForwardKinematics.CheckPose(pose, nameof(pose));
        if (double.IsNaN(arrivalSeconds) || double.IsInfinity(arrivalSeconds) || _ring.Free is not { } slot)
        {
            Interlocked.Increment(ref _dropped);
            return false;
        }

        pose[..BoneHierarchy.BoneCount].CopyTo(slot.Pose);
        slot.Arrival = arrivalSeconds;
        slot.Index = frameIndex;
        slot.Tag = tag;
        _ring.Publish();
        return true;
    }

    /// <summary>
    /// Computes the pose at a time. Call it from one thread. It never waits and does not allocate memory. Times may have any order, but usually
    /// ascend.
    /// </summary>
    /// <param name="seconds">
    /// The display time of the pose, on the clock of the arrivals. The pose belongs to a time that is <see cref="PoseBufferOptions.Delay"/>
    /// earlier.
    /// </param>
    /// <param name="pose">Receives 59 transforms relative to their parents.</param>
    /// <returns>The origin of the pose; <see cref="PoseOrigin.None"/> if no pose was written.</returns>
    /// <exception cref="ArgumentException">The span is too short.</exception>
    public PoseOrigin Sample(double seconds, Span<BoneTransform> pose)
    {
        ForwardKinematics.CheckRoom(pose, nameof(pose));
        for (int end = _ring.End; _taken != end; _taken++)
            Take(_ring.At(_taken));

        PoseOrigin origin = _timeline.Sample(seconds - _delay, _clock.Interval, _clock.IsSettled, pose);
        _ring.Release(_taken);
        return origin;
    }

    private void Take(PoseSlot slot)
    {
        slot.IsDone = false;
        if (_clock.Place(slot.Arrival, slot.Index) is { } time)
        {
            slot.Time = time;
            if (_clock.IsSettled && slot.Arrival - time > _delay)
                Late++;

            _timeline.Add(slot);
        }
        else
        {
            slot.IsDone = true;
        }
    }
}
