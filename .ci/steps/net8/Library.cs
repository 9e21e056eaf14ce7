using System;
using System.Threading;
using System.Threading.Tasks;
using NeuronMocap;
using NeuronMocap.Motion;
using NeuronMocap.Server;

/// <summary>Sets options and reads results, so that a member that the two builds of the packages do not share is found.</summary>
public static class Demo
{
    public static async Task<long> ReceiveAsync(int wanted)
    {
        await using var server = new Broadcaster(new BroadcasterOptions { Port = 0, Sources = new[] { new SyntheticSource() } });
        server.Start();

        await using var reader = new NeuronReader(new NeuronReaderOptions { Host = "127.0.0.1", Port = server.LocalEndPoint!.Port });
        using var tooLate = new CancellationTokenSource(TimeSpan.FromSeconds(60));
        reader.Start();
        int received = 0;
        await foreach (var frame in reader.ReadMotionAsync(tooLate.Token))
        {
            if (++received == wanted)
                break;
        }

        var buffer = new PoseBuffer(new PoseBufferOptions { Capacity = 16 });
        ReaderStatistics statistics = reader.GetStatistics();
        return buffer.GetType() == typeof(PoseBuffer) ? Math.Min(statistics.MotionFrames, received) : 0;
    }
}
