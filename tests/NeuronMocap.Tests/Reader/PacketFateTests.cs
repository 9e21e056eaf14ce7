using FsCheck;
using FsCheck.Fluent;
using NeuronMocap.Protocol;
using NeuronMocap.Reader;
using NeuronMocap.Tests.Delivery;

namespace NeuronMocap.Tests.Reader;

/// <summary>
/// Compares a reader's counts for packets and bytes of damaged streams with a reading of the whole stream by <see cref="ReferenceScanner"/>. Every
/// packet is delivered, skipped or undelivered. Every delivered frame is taken, dropped or waiting. Every other byte is skipped.
/// </summary>
public sealed class PacketFateTests
{
    [Fact]
    public void Every_packet_and_byte_is_counted_once()
    {
        Gen<FateCase> cases =
            from stream in WireStream.Any
            from capacity in Gen.Choose(1, 4)
            from pieces in Gen.Frequency((1, Gen.Constant(int.MaxValue)), (2, Gen.Choose(0, 30)))
            from pumpEvery in Gen.Choose(1, 40)
            select new FateCase(stream, capacity, pieces, pumpEvery);
        long delivered = 0;
        long dropped = 0;
        long passedOver = 0;
        long undelivered = 0;
        long skipped = 0;
        Properties.Hold(cases, static one => one.Simpler(), count: 1_500, one =>
        {
            byte[] bytes = one.Stream.ToBytes();
            ReferenceReading expected = ReferenceScanner.Read(bytes, WireStream.MaxValues);
            ReceivePipeline pipeline = DeliveryBench.CreatePipeline();
            using FrameQueue queue = pipeline.OpenQueue(one.Capacity, "fates");
            var window = new ManualContext();
            FrameDelivery every = Open(pipeline, window, FrameDeliveryMode.EveryFrame, one.Capacity);
            FrameDelivery newest = Open(pipeline, window, FrameDeliveryMode.Newest, one.Capacity);
            int stoppedAt = Push(one, bytes, pipeline, queue, window);
            ReferenceReading beforeStop = ReferenceScanner.Read(bytes[..stoppedAt], WireStream.MaxValues);

            ReaderStatistics statistics = pipeline.GetStatistics();
            long frames = statistics.MotionFrames + statistics.CalculationFrames + statistics.StudioCalculationFrames;
            Assert.Equal(expected.Packets.Count, statistics.PacketsReceived);
            Assert.Equal(beforeStop.Packets.Count, frames + statistics.CommandPackets + statistics.EmptyPackets);
            Assert.Equal(expected.Packets.Count - beforeStop.Packets.Count, statistics.Undelivered);
            Assert.Equal(beforeStop.Packets.Count(IsFrame), frames);
            Assert.Equal(frames, queue.Delivered + queue.Dropped + queue.Count);
            Assert.Equal(frames, every.Delivered + every.Dropped + every.Pending);
            Assert.Equal(frames, newest.Delivered + newest.Dropped + newest.Replaced + newest.Pending);
            Assert.Equal(queue.Dropped + every.Dropped, statistics.Dropped);
            if (stoppedAt == bytes.Length)
            {
                Assert.Equal((bytes.Length - expected.Pending, expected.Skipped), (statistics.BytesReceived, statistics.BytesSkipped));
                Assert.Equal(
                    statistics.BytesReceived,
                    statistics.BytesSkipped + expected.Text + expected.Packets.Where(static packet => !TextLine.IsImage(packet.Bytes)).Sum(static packet => packet.Bytes.Length));
            }

            queue.Pump<AvatarFrame>(static _ => { });
            Assert.Equal(statistics.PacketsReceived, queue.Delivered + queue.Dropped + statistics.CommandPackets + statistics.EmptyPackets + statistics.Undelivered);
            delivered += queue.Delivered;
            dropped += queue.Dropped;
            passedOver += statistics.CommandPackets + statistics.EmptyPackets;
            undelivered += statistics.Undelivered;
            skipped += statistics.BytesSkipped;
        });
        Assert.All([delivered, dropped, passedOver, undelivered, skipped], static count => Assert.True(count > Trials.Fewest(100), "The cases are too poor to prove anything."));
    }

    // Returns the number of bytes that were pushed before the reader stopped.
    private static int Push(FateCase one, byte[] bytes, ReceivePipeline pipeline, FrameQueue queue, ManualContext window)
    {
        var assembler = new PacketAssembler(new PacketScanner(WireStream.MaxValues), pipeline);
        int pushed = 0;
        int? stoppedAt = null;
        int piece = 0;
        foreach (ArraySegment<byte> bytesOfPiece in one.Stream.Cut(bytes))
        {
            if (piece == one.PiecesBeforeStop)
            {
                pipeline.Stop();
                stoppedAt = pushed;
            }

            assembler.Push(bytesOfPiece, timestamp: piece);
            pushed += bytesOfPiece.Count;
            if (++piece % one.PumpEvery != 0)
                continue;

            queue.Pump<AvatarFrame>(static _ => { });
            window.RunAll();
        }

        return stoppedAt ?? pushed;
    }

    private static FrameDelivery Open(ReceivePipeline pipeline, SynchronizationContext window, FrameDeliveryMode mode, int capacity) =>
        pipeline.OpenDelivery(new FrameDeliveryOptions { Context = window, Mode = mode, Capacity = capacity }, new FakeDeliveryClock(), static _ => { });

    private static bool IsFrame(FoundPacket packet) => packet.Kind != PacketKind.Command && packet.Bytes.Length > ProtocolConstants.HeaderSize;

    private sealed record FateCase(WireStream Stream, int Capacity, int PiecesBeforeStop, int PumpEvery)
    {
        public IEnumerable<FateCase> Simpler() => Stream.Simpler().Select(stream => this with { Stream = stream });
    }
}
