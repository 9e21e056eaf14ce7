using System.Diagnostics;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>Encodes the frames of sources, at an even rate.</summary>
/// <param name="plan">What to encode.</param>
/// <param name="rate">Frames per second.</param>
/// <param name="log">Where to publish.</param>
/// <param name="ended">As the base has it.</param>
internal sealed class FramePacer(FramePlan plan, double rate, FrameLog log, Action<Exception?> ended) : Pacer(ended)
{
    protected override void PublishAll()
    {
        var clock = new FrameClock(rate, Stopwatch.GetTimestamp());
        FrameEncoder encoder = plan.CreateEncoder();
        byte[] bytes = new byte[plan.MaxFrameSize];
        for (long frame = 0; frame < plan.FrameCount; frame++)
        {
            // Encoded before its time comes, so that the work delays nothing.
            int length = encoder.Encode(frame, bytes);
            if (!WaitFor(frame, clock))
                return;

            log.Publish(bytes.AsSpan(0, length));
        }
    }

    // False when the broadcast is stopped first.
    private bool WaitFor(long frame, FrameClock clock)
    {
        lock (Gate)
        {
            int delay;
            while (!IsStopping && (delay = clock.GetDelay(frame, Stopwatch.GetTimestamp())) > 0)
                Monitor.Wait(Gate, delay);

            return !IsStopping;
        }
    }
}
