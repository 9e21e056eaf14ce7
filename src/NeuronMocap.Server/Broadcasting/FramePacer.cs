using System.Diagnostics;
using NeuronMocap.Recording;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>Encodes the frames of sources at an even rate. Where time allows, it spreads the packets of a frame over the time of the frame.</summary>
/// <param name="streams">The plans to encode, and the logs to publish to. All plans concern the same frames.</param>
/// <param name="rate">Frames per second.</param>
/// <param name="ended">See the base class.</param>
/// <param name="report">See the base class.</param>
/// <param name="time">The clock; null for the real one.</param>
internal sealed class FramePacer(
    IReadOnlyList<(FramePlan Plan, FrameLog Log)> streams, double rate, Action<Exception?> ended, FaultReport report, PacerTime? time = null)
    : Pacer(ended, report)
{
    private static readonly long MinSpacing = PacketSpacing.MinSpacing * Stopwatch.Frequency / 1000;

    private readonly PacerTime _time = time ?? PacerTime.Real;
    private long _published;

    protected override void PublishAll()
    {
        int packets = streams.Max(static stream => stream.Plan.PacketsPerFrame);
        var spread = new PacketSpacing(rate, packets);
        int steps = spread.IsPacketwise ? packets : 1;
        using TimerResolution? resolution = steps > 1 ? TimerResolution.Raise() : null;
        var clock = new FrameClock(rate, _time.Now);
        PacedStream[] paced = [.. streams.Select(static stream => new PacedStream(stream.Plan, stream.Log))];
        _published = _time.Now - MinSpacing;
        long count = streams[0].Plan.FrameCount;
        for (long frame = 0; frame < count; frame++)
        {
            // Encoded before the frame is due, so that the work does not delay it.
            foreach (PacedStream stream in paced)
                stream.Encode(frame);

            for (int step = 0; step < steps; step++)
            {
                if (!WaitFor(spread.GetTime(frame, step), clock, spreadUntil: steps > 1 ? frame + 1 : frame))
                    return;

                foreach (PacedStream stream in paced)
                    stream.Publish(steps > 1);
            }
        }
    }

    // Returns false when the broadcast is stopped first. Late packets keep their distance until spreadUntil. From then on they are sent at once,
    // so that spreading never delays a frame.
    private bool WaitFor(double due, FrameClock clock, long spreadUntil)
    {
        lock (Lock)
        {
            int delay;
            while (!IsStopping && (delay = GetDelay(due, clock, spreadUntil)) > 0)
                _time.Wait(Lock, delay);

            _published = _time.Now;
            return !IsStopping;
        }
    }

    private int GetDelay(double due, FrameClock clock, long spreadUntil)
    {
        long now = _time.Now;
        int delay = clock.GetDelay(due, now);
        return clock.GetDelay(spreadUntil, now) > 0 ? Math.Max(delay, GetRest(now)) : delay;
    }

    private int GetRest(long now) => (int)Math.Ceiling(Math.Max(0, _published + MinSpacing - now) * 1000.0 / Stopwatch.Frequency);

    private sealed class PacedStream(FramePlan plan, FrameLog log)
    {
        private readonly FrameEncoder _encoder = plan.CreateEncoder();
        private readonly UnitBatch _frame = new(plan.MaxFrameSize);
        private int _offset;
        private int _place;

        public void Encode(long frame)
        {
            _frame.SetSingle(_encoder.Encode(frame, _frame.Bytes));
            _offset = 0;
            _place = 0;
        }

        // Publishes the next packet, or the whole frame. With isPacket, nothing happens after the last packet.
        public void Publish(bool isPacket)
        {
            if (!isPacket)
            {
                log.Publish(_frame);
                return;
            }

            ReadOnlySpan<byte> rest = _frame.BytesOf(0)[_offset..];
            if (rest.IsEmpty)
                return;

            int size = plan.MeasurePacket(rest, plan.IsMotion(_place++));
            log.Publish(rest[..size], packets: 1);
            _offset += size;
        }
    }
}
