using NeuronMocap.Frames;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Network;

internal static class ReaderExtensions
{
    // A reader of a TCP server that waits as the test says, not as the number of the process's connections has it.
    public static NeuronReader CreateReader(this NeuronReaderOptions options, Func<TcpReceiver> takeReceiver) =>
        new(options, () => new TcpLink(options.Link with { TakeReceiver = takeReceiver }));

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
