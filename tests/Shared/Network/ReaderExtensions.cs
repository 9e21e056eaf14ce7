namespace NeuronMocap.Tests.Network;

internal static class ReaderExtensions
{
    // Waits until that many motion frames have reached every consumer.
    public static Task WaitForFramesAsync(this NeuronReader reader, long count) => reader.UntilAsync(statistics => statistics.MotionFrames >= count);

    // A packet is counted before the first consumer gets it: waits until the last one has got the newest, too.
    public static Task UntilAsync(this NeuronReader reader, Func<ReaderStatistics, bool> condition) =>
        Limits.UntilAsync(() => condition(reader.GetStatistics()) && !reader.IsDelivering);
}
