using NeuronMocap.Skeleton;

namespace NeuronMocap.Motion;

/// <summary>
/// From frames that come when they come to poses at the moments of another clock, such as a display's: a jitter buffer. It finds the sender's even clock
/// in the arrivals, and gives the pose at any moment of it, a chosen delay in the past, between the frames that it has. When none comes in time
/// the motion goes on for a short while and stops. Late, doubled and missing frames, frames that come at once, another rate and a
/// counter that starts again are all taken as they come.
/// <para>
/// One thread pushes, usually the receive thread; one other samples. Neither ever waits for the other, a pose is never half of one frame and half of
/// another, and nothing is allocated after the constructor. One buffer for each avatar.
/// </para>
/// </summary>
public sealed class PoseBuffer
{
    private readonly double _delay;
    private readonly PoseRing _ring;
    private readonly ArrivalClock _clock = new();
    private readonly PoseTimeline _timeline;

    private long _dropped;
    private int _taken;

    /// <summary>Makes a buffer.</summary>
    /// <param name="options">Delay and limits; null for the defaults.</param>
    /// <exception cref="ArgumentOutOfRangeException">One of the options is out of range.</exception>
    public PoseBuffer(PoseBufferOptions? options = null)
    {
        options = PoseBufferOptions.Check(options ?? new PoseBufferOptions());
        _delay = options.Delay.TotalSeconds;
        _ring = new PoseRing(options.Capacity);
        _timeline = new PoseTimeline(options, _ring.Capacity);
    }

    /// <summary>Frames that came while there was no room: nobody sampled for long, or the delay is too long for the capacity. Any thread may ask.</summary>
    public long DroppedCount => Interlocked.Read(ref _dropped);

    /// <summary>Seconds from one frame to the next on the sender's clock, of those that came, in the mean of the last few; 0 before it is known. Ask the sampling thread.</summary>
    public double FrameInterval => _clock.Interval;

    /// <summary>
    /// Seconds by which arrivals miss the sender's even clock, in the mean. A delay of one frame and four times this is rarely too short. Ask the
    /// sampling thread.
    /// </summary>
    public double Jitter => _clock.Jitter;

    /// <summary>Adds a frame. For one thread, the same or another one than that of <see cref="Sample"/>; never waits, allocates nothing.</summary>
    /// <param name="pose">
    /// 59 transforms relative to their parents, in <see cref="Bone"/> order; copied. What is relative to a moving Reference node is not
    /// brought into the world here.
    /// </param>
    /// <param name="arrivalSeconds">When the frame was received, on the clock that samples are asked for on.</param>
    /// <param name="frameIndex">The sender's counter, where it has one: it tells what is missing, doubled or in another order.</param>
    /// <returns>False when there was no room, or the time is not a number: the frame is dropped and counted.</returns>
    /// <exception cref="ArgumentException">There are fewer than 59 transforms.</exception>
    public bool Push(ReadOnlySpan<BoneTransform> pose, double arrivalSeconds, uint? frameIndex = null)
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
        _ring.Publish();
        return true;
    }

    /// <summary>Gives the pose of a moment. For one thread; never waits, allocates nothing. Moments may come in any order, and usually ascend.</summary>
    /// <param name="seconds">When the pose is shown, on the clock of the arrivals; the pose is that of <see cref="PoseBufferOptions.Delay"/> before.</param>
    /// <param name="pose">Receives 59 transforms relative to their parents.</param>
    /// <returns>What the pose was made of; <see cref="PoseOrigin.None"/> when none was written.</returns>
    /// <exception cref="ArgumentException">There is less room.</exception>
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
            _timeline.Add(slot);
        }
        else
        {
            slot.IsDone = true;
        }
    }
}
