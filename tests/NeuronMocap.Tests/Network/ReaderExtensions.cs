namespace NeuronMocap.Tests.Network;

internal static class ReaderExtensions
{
    // Waits until that many motion frames have arrived.
    public static async Task WaitForFramesAsync(this NeuronReader reader, long count)
    {
        var arrived = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
        reader.MotionReceived += Check;
        if (reader.GetStatistics().MotionFrames >= count)
            arrived.TrySetResult();

        await arrived.Task.Soon();
        reader.MotionReceived -= Check;

        void Check(MotionFrame frame)
        {
            if (reader.GetStatistics().MotionFrames >= count)
                arrived.TrySetResult();
        }
    }
}
