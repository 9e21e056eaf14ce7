using System.Buffers;
using System.IO.Pipelines;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Transport;

public sealed partial class ByteReceiverTests
{
    [Fact]
    public async Task Segments_of_every_size()
    {
        for (int size = 1; size <= Bytes.Length; size++)
            AssertReceived(await ReceiveAsync(PipeOf(Bytes.Chunk(size))));
    }

    [Theory]
    [EverySplitting("mixed", "text", "studio-354", "new-180", "calculation", "zero-count")]
    public async Task Segments_of_a_stream(string name, Splitting splitting)
    {
        if (IsTriedElsewhere(name, splitting))
            return;

        byte[] bytes = StreamFixture.Load(name).Bytes;
        PacketLog whole = Whole(bytes);
        foreach (IEnumerable<ArraySegment<byte>> pieces in Splits.Of(bytes, splitting))
            AssertSame(whole, await ReceiveAsync(PipeOf(pieces.Select(static piece => piece.ToArray()))));
    }

    [Theory]
    [EverySplitting("mixed", "text", "studio-354", "new-180", "calculation", "zero-count")]
    public async Task Reads_of_a_pipe(string name, Splitting splitting)
    {
        if (IsTriedElsewhere(name, splitting))
            return;

        byte[] bytes = StreamFixture.Load(name).Bytes;
        PacketLog whole = Whole(bytes);
        foreach (IEnumerable<ArraySegment<byte>> pieces in Splits.Of(bytes, splitting))
        {
            var pipe = new Pipe(new PipeOptions(readerScheduler: PipeScheduler.Inline, writerScheduler: PipeScheduler.Inline, minimumSegmentSize: 64));
            Task<PacketLog> receiving = ReceiveAsync(new PipeReceiver(pipe.Reader));
            foreach (ArraySegment<byte> piece in pieces)
                await pipe.Writer.WriteAsync(piece, TestContext.Current.CancellationToken);

            await pipe.Writer.CompleteAsync();
            AssertSame(whole, await receiving);
        }
    }

    [Theory]
    [EverySplitting("mixed", "text", "studio-354")]
    public async Task Reads_of_a_stream_through_a_pipe(string name, Splitting splitting)
    {
        // Some eight thousand splits, each with a change of threads, would take too long.
        if (splitting == Splitting.EverySplitInTwo)
            return;

        byte[] bytes = StreamFixture.Load(name).Bytes;
        PacketLog whole = Whole(bytes);
        foreach (IEnumerable<ArraySegment<byte>> pieces in Splits.Of(bytes, splitting))
        {
            Stream stream = new FedStream().Feed([.. pieces.Select(static piece => piece.ToArray())]).End();
            AssertSame(whole, await ReceiveAsync(ByteReceivers.Create(stream, leaveOpen: false, ReceiveThread.Pool)));
        }
    }

    [Fact]
    public async Task Packets_lie_in_the_segments()
    {
        byte[] first = TestPackets.Motion(1);
        byte[] second = TestPackets.Motion(2);
        byte[] third = TestPackets.Motion(3);
        var places = new PlaceLog();
        var receiver = new PipeReceiver(PipeReader.Create(Sequence.Of([first, [.. second, .. third[..100]], third[100..]])));
        await receiver.ReceiveAsync(new PacketAssembler(new PacketScanner(), places), new ReceiveGate()).Soon();
        Assert.Equal(3, places.Arrays.Count);
        Assert.Same(first, places.Arrays[0]);
        Assert.Equal(second, places.Arrays[1].Take(second.Length));
        Assert.NotSame(third, places.Arrays[2]);
    }

    [Fact]
    public async Task Memory_outside_the_heap_is_read()
    {
        using var memory = new ForeignMemory(TestPackets.Motions(0, 300));
        PacketLog log = await ReceiveAsync(new PipeReceiver(PipeReader.Create(new ReadOnlySequence<byte>(memory.Memory))));
        Assert.Equal(memory.Memory.ToArray(), log.Packets.SelectMany(static packet => packet.Bytes));
    }

    [Fact]
    public async Task Large_segments_become_pieces_that_recordings_can_hold()
    {
        var tap = new StreamTap();
        var sizes = new PieceLog();
        tap.Add(sizes, 0);
        tap.Open(isDatagrams: false, local: null, remote: null, 0);
        byte[] bytes = TestPackets.Motions(0, 1000);
        var log = new PacketLog();
        var receiver = new PipeReceiver(PipeReader.Create(new ReadOnlySequence<byte>(bytes)));
        await receiver.ReceiveAsync(new PacketAssembler(new PacketScanner(), log, tap), new ReceiveGate()).Soon();
        Assert.Equal(1000, log.Packets.Count);
        Assert.Equal(bytes.Length, sizes.Sizes.Sum());
        Assert.All(sizes.Sizes, static size => Assert.InRange(size, 1, 256 * 1024));
    }

    // The scanner has every split of every stream. Here, the streams differ only in their length.
    private static bool IsTriedElsewhere(string name, Splitting splitting) => splitting == Splitting.EverySplitInTwo && name != "mixed";

    private static PipeReceiver PipeOf(IEnumerable<byte[]> segments) => new(PipeReader.Create(Sequence.Of(segments)));

    private sealed class PlaceLog : IPacketReceiver
    {
        public List<byte[]> Arrays { get; } = [];

        public void OnPacket(in ReceivedPacket packet) => Arrays.Add(packet.Array);

        public void OnText(ReadOnlySpan<byte> bytes, PacketKind kind)
        {
        }

        public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason)
        {
        }
    }

    private sealed class PieceLog : IStreamListener
    {
        public List<int> Sizes { get; } = [];

        public void OnOpened(StreamConnection connection, bool wasOpen, long timestamp)
        {
        }

        public void OnBytes(StreamConnection connection, int number, byte[] sender, ArraySegment<byte> bytes, long timestamp) => Sizes.Add(bytes.Count);

        public void OnClosed(StreamConnection connection, string reason, long timestamp)
        {
        }
    }

    private sealed class ForeignMemory(byte[] bytes) : MemoryManager<byte>
    {
        public override Span<byte> GetSpan() => bytes;

        public override MemoryHandle Pin(int elementIndex = 0) => throw new NotSupportedException();

        public override void Unpin()
        {
        }

        protected override void Dispose(bool disposing)
        {
        }
    }

    private sealed class Sequence : ReadOnlySequenceSegment<byte>
    {
        public static ReadOnlySequence<byte> Of(IEnumerable<byte[]> segments)
        {
            Sequence? first = null;
            Sequence? last = null;
            foreach (byte[] bytes in segments)
            {
                var next = new Sequence { Memory = bytes, RunningIndex = last is null ? 0 : last.RunningIndex + last.Memory.Length };
                if (last is not null)
                    last.Next = next;

                (first, last) = (first ?? next, next);
            }

            return first is null ? default : new ReadOnlySequence<byte>(first, 0, last!, last!.Memory.Length);
        }
    }
}
