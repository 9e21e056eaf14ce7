using NeuronMocap.Recording;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Broadcasting;

// The frames of a plan as the events of a recording: one connection, on which each frame arrives at once.
internal sealed class MotionEvents(FramePlan plan, string name) : RecordedEventSource(name)
{
    private readonly FrameEncoder _encoder = plan.CreateEncoder();
    private readonly byte[] _bytes = new byte[plan.MaxFrameSize];
    private bool _isOpened;
    private long _next;

    public override string Target => $"motion {FilePath}";

    public override string Origin => "the source";

    // Includes the last interval, so that a loop continues at the same rate.
    public override TimeSpan Duration => plan.FrameCount == long.MaxValue ? TimeSpan.MaxValue : TimeOf(plan.FrameCount);

    public override RotationOrder? RotationOrder => plan.Order;

    public override SkeletonVariant? SkeletonVariant => plan.Sources[0].Variant;

    public override RecordedEvent Read()
    {
        if (!_isOpened)
        {
            _isOpened = true;
            return new RecordedEvent(RecordedEventKind.Opened, TimeSpan.Zero);
        }

        if (_next >= plan.FrameCount)
            return new RecordedEvent(RecordedEventKind.End, Duration);

        int length = _encoder.Encode(_next, _bytes);
        return new RecordedEvent(RecordedEventKind.Bytes, TimeOf(_next++)) { Bytes = new ArraySegment<byte>(_bytes, 0, length) };
    }

    public override bool Seek(TimeSpan time)
    {
        _next = Math.Clamp(RecordedTime.ToTicks(time.TotalSeconds * plan.FrameRate), 0, plan.FrameCount);
        _isOpened = _next > 0;
        return _next == 0;
    }

    public override void Dispose()
    {
    }

    private TimeSpan TimeOf(long frame) => TimeSpan.FromTicks(RecordedTime.ToTicks(Math.Round(frame * (double)TimeSpan.TicksPerSecond / plan.FrameRate)));
}
