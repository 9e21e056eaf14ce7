using System.Diagnostics.Metrics;
using System.IO.Pipelines;
using System.Net.Sockets;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Reader;

public sealed partial class AllocationTests
{
    [Fact]
    public Task A_connection_without_a_thread_costs_no_allocation_per_frame() => MeasureTcpAsync(
        reader =>
        {
            FrameQueue queue = reader.OpenQueue(FramesPerRound);
            float sum = 0;
            reader.MotionReceived += frame => sum += frame.Values[0];
            Action<MotionFrame> handler = frame => sum += frame.Values[^1];
            return () => queue.Pump(handler);
        },
        static () => new PooledTcpReceiver());

    [Fact]
    public Task A_stream_without_a_thread_costs_no_allocation_per_frame() =>
        MeasureStreamAsync(static stream => new NeuronReader(stream, SourceReaderTests.Options(ReceiveThread.Pool)));

    [Fact]
    public Task A_stream_that_keeps_a_buffer_costs_no_allocation_per_frame() =>
        MeasureStreamAsync(static stream => new NeuronReader(new PlainStream(((NetworkStream)stream).Socket), SourceReaderTests.Options(ReceiveThread.Pool)));

    [Fact]
    public Task A_pipe_costs_no_allocation_per_frame() =>
        MeasureStreamAsync(static stream => new NeuronReader(PipeReader.Create(stream), SourceReaderTests.Options()));

    [Fact]
    public async Task Metrics_that_are_listened_to_cost_no_allocation_per_frame()
    {
        using var listener = new MeterListener();
        long recorded = 0;
        listener.InstrumentPublished = (instrument, self) =>
        {
            if (instrument.Meter.Name == "NeuronMocap")
                self.EnableMeasurementEvents(instrument);
        };
        listener.SetMeasurementEventCallback<double>((_, _, tags, _) => Interlocked.Add(ref recorded, tags.Length > 1 ? 1 : 0));
        listener.Start();

        await MeasureTcpAsync(reader =>
        {
            FrameQueue queue = reader.OpenQueue(FramesPerRound);
            float sum = 0;
            Action<MotionFrame> handler = frame => sum += frame.Values[^1];
            return () => queue.Pump(handler);
        });

        // The hand-over of each frame, and the interval before it except for the first: two rounds of warm-up and at least one measured round.
        Assert.InRange(recorded, (2 * 3 * FramesPerRound) - 1, long.MaxValue);
    }

    // Not known to the library as a stream whose empty reads wait.
    private sealed class PlainStream(Socket socket) : NetworkStream(socket, ownsSocket: true);
}
