using System.Buffers.Binary;
using System.Diagnostics;
using System.Globalization;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Reader;

// A day at 120 Hz is 10,368,000 frames. An environment variable sets the number. Frames go through real TCP, whose flow control sets the pace. The
// frame index wraps around in the middle. Alone, because it measures the memory of the whole process.
[Collection(nameof(Alone))]
public sealed class SoakTests(ITestOutputHelper output)
{
    private const string Variable = "NEURONMOCAP_SOAK_FRAMES";
    private const int FramesPerWrite = 50;
    private const int Samples = 10;
    private const int IndexOffset = 46;
    private const int ValueOffset = 64 + (4 * 100);
    private const int FrameSize = 1480;

    // Covers some status messages and the test runner. A byte for each frame of a day would be ten times as much.
    private const long HeapRoom = 1_000_000;

    // Covers code that is recompiled at run time, and the runtime's own memory.
    private const long WorkingSetRoom = 64_000_000;

    private static readonly long Frames = long.Parse(Environment.GetEnvironmentVariable(Variable) ?? "500000", CultureInfo.InvariantCulture);

    private readonly List<(long Heap, long WorkingSet)> _samples = [];
    private long _received;
    private long _wrong;
    private long _newest;

    [Fact]
    public async Task A_day_of_frames_loses_none_and_memory_stays_flat()
    {
        long writes = Frames / FramesPerWrite;
        uint first = unchecked((uint)-(Frames / 2));
        using var server = new TestServer();
        await using var reader = new NeuronReader(server.Options());
        reader.MotionReceived += frame => Check(frame, first);
        using LatestFrames latest = reader.OpenLatest();
        reader.Start();
        using TestConnection connection = await server.AcceptAsync();

        var watch = Stopwatch.StartNew();
        byte[] bytes = TestPackets.Motions(0, FramesPerWrite);
        for (long write = 0; write < writes; write++)
        {
            // The first tenth fills everything that is filled once.
            if (write > 0 && write % (writes / Samples) == 0)
                await SampleAsync(write * FramesPerWrite);

            for (int i = 0; i < FramesPerWrite; i++)
                Number(bytes.AsSpan(i * FrameSize), unchecked(first + (uint)((write * FramesPerWrite) + i)));

            connection.Socket.Send(bytes);
            if (latest.TryTakeMotion(0, out MotionFrame? newest))
                _newest = (long)newest.FrameIndex!;
        }

        long sent = writes * FramesPerWrite;
        await Limits.UntilAsync(() => Volatile.Read(ref _received) == sent);
        watch.Stop();
        ReaderStatistics statistics = reader.GetStatistics();
        foreach ((long heap, long workingSet) in _samples)
            output.WriteLine($"{heap,12:N0} bytes of heap, {workingSet / 1e6,8:N1} MB of working set");

        output.WriteLine($"{sent:N0} frames in {watch.Elapsed.TotalSeconds:N1} s, {sent / watch.Elapsed.TotalSeconds:N0} frames/s; the newest seen was {_newest:N0}");

        Assert.Equal((sent, 0L, 0L), (statistics.MotionFrames, statistics.Lost, statistics.BytesSkipped));
        Assert.Equal((sent * FrameSize, 0L), (statistics.BytesReceived, Assert.Single(reader.GetAvatarStatistics()).OutOfOrder));
        Assert.Equal(0, _wrong);
        Assert.InRange(_samples.Max(sample => sample.Heap) - _samples[0].Heap, long.MinValue, HeapRoom);
        Assert.InRange(_samples.Max(sample => sample.WorkingSet) - _samples[0].WorkingSet, long.MinValue, WorkingSetRoom);
    }

    // Every frame has the next index, across the wrap, and carries that index among its values too.
    private void Check(MotionFrame frame, uint first)
    {
        uint expected = unchecked(first + (uint)_received);
        if (frame.FrameIndex != expected || BitConverter.SingleToUInt32Bits(frame.Values[100]) != expected)
            _wrong++;

        Volatile.Write(ref _received, _received + 1);
    }

    private static void Number(Span<byte> packet, uint index)
    {
        BinaryPrimitives.WriteUInt32LittleEndian(packet[IndexOffset..], index);
        BinaryPrimitives.WriteUInt32LittleEndian(packet[ValueOffset..], index);
    }

    // When nothing is in transit, so that only kept memory counts.
    private async Task SampleAsync(long sent)
    {
        await Limits.UntilAsync(() => Volatile.Read(ref _received) == sent);
        _samples.Add((ProcessResources.LiveHeap(), Environment.WorkingSet));
    }
}
