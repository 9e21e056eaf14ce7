namespace NeuronMocap.Tests.Network;

internal static class ReaderExtensions
{
    // Waits until this number of motion frames has reached every consumer.
    public static Task WaitForFramesAsync(this NeuronReader reader, long count) => reader.UntilAsync(statistics => statistics.MotionFrames >= count);

    // A packet is counted before the first consumer receives it. This waits until the last consumer has the newest one too.
    public static Task UntilAsync(this NeuronReader reader, Func<ReaderStatistics, bool> condition) =>
        Limits.UntilAsync(() => condition(reader.GetStatistics()) && !reader.IsDelivering);
}
