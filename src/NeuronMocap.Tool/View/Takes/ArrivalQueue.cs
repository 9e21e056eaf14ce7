using System.Runtime.InteropServices;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>A received frame that waits for those after it.</summary>
/// <param name="Time">Arrival in microseconds.</param>
/// <param name="Index">The server's counter.</param>
/// <param name="Distance">Frames since the one before; 0 if that is unknown.</param>
/// <param name="Pose">59 transforms relative to the parent.</param>
/// <param name="Measured">The contacts that the file holds.</param>
internal readonly record struct ArrivedFrame(long Time, uint Index, int Distance, BoneTransform[] Pose, FootContacts? Measured);

/// <summary>Finds out when frames were sent that arrived late: a busy network or computer delivers the frames of a second at once.</summary>
/// <remarks>
/// A frame was sent no later than its successors say: the arrival of a later frame, less the frames between them. Pauses of the server stay, because
/// an arrival is never moved to a later time. Without this, a delay of a second would be a gap, and the motion after it many times too fast.
/// </remarks>
/// <param name="write">Receives each frame with its time in microseconds.</param>
internal sealed class ArrivalQueue(Action<ArrivedFrame, long> write)
{
    private const int Capacity = 512; // frames

    private readonly List<ArrivedFrame> _frames = [];
    private readonly Stack<BoneTransform[]> _free = new();

    /// <summary>Adds a frame. Copies the pose.</summary>
    /// <param name="time">Arrival in microseconds.</param>
    /// <param name="index">The server's counter.</param>
    /// <param name="distance">Frames since the one before; 0 if that is unknown.</param>
    /// <param name="pose">59 transforms relative to the parent.</param>
    /// <param name="measured">The contacts that the file holds.</param>
    /// <param name="rate">Frames per second; null if it is unknown.</param>
    public void Add(long time, uint index, int distance, ReadOnlySpan<BoneTransform> pose, FootContacts? measured, double? rate)
    {
        if (!_free.TryPop(out BoneTransform[]? copy))
            copy = new BoneTransform[BoneHierarchy.BoneCount];

        pose[..BoneHierarchy.BoneCount].CopyTo(copy);
        _frames.Add(new ArrivedFrame(time, index, distance, copy, measured));
        if (_frames.Count == Capacity)
            Release(Capacity / 2, rate);
    }

    /// <summary>Writes all frames.</summary>
    public void Finish(double? rate) => Release(_frames.Count, rate);

    private void Release(int count, double? rate)
    {
        Span<long> times = stackalloc long[Capacity];
        ReadOnlySpan<ArrivedFrame> frames = CollectionsMarshal.AsSpan(_frames);
        double step = rate is { } known ? 1e6 / known : 0;
        double next = double.PositiveInfinity;
        for (int i = frames.Length - 1; i >= 0; i--)
        {
            next = Math.Min(frames[i].Time, next);
            times[i] = (long)Math.Round(next);
            next = step > 0 && frames[i].Distance > 0 ? next - (frames[i].Distance * step) : double.PositiveInfinity;
        }

        for (int i = 0; i < count; i++)
        {
            write(frames[i], times[i]);
            _free.Push(frames[i].Pose);
        }

        _frames.RemoveRange(0, count);
    }
}
