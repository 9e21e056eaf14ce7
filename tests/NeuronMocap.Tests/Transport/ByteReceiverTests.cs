using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;
using NeuronMocap.Transport;

namespace NeuronMocap.Tests.Transport;

// However the bytes of a source are divided, the packets are the same.
public sealed partial class ByteReceiverTests
{
    // All kinds of packets, with noise between them, in few bytes: these tests try every size.
    private static readonly byte[] Noise = [0xFF, 0xDD, 1, 2, 3, 0xFF, 0xFF, 0x88, 0xFF];

    private static readonly byte[][] Packets =
        [TestPackets.Motion(1, count: 3), TestPackets.Motion(2, layout: HeaderLayout.Old, count: 3), TestPackets.Calculation(3, count: 7), TestPackets.Motion(5, count: 9)];

    private static readonly byte[] Bytes = [.. Noise, .. Packets[0], .. Packets[1], .. Noise, .. Packets[2], .. Packets[3]];

    [Fact]
    public async Task Blocking_reads_of_every_size()
    {
        for (int size = 1; size <= Bytes.Length; size++)
            AssertReceived(await ReceiveAsync(BlockingOf(Bytes.Chunk(size))));
    }

    [Fact]
    public async Task Blocking_reads_with_every_split()
    {
        for (int split = 1; split < Bytes.Length; split++)
            AssertReceived(await ReceiveAsync(BlockingOf([Bytes[..split], Bytes[split..]])));
    }

    [Theory]
    [EverySplitting("mixed", "text", "studio-354")]
    public async Task Blocking_reads_of_a_stream(string name, Splitting splitting)
    {
        // A thread for each of some ten thousand splits would take too long.
        if (splitting == Splitting.EverySplitInTwo)
            return;

        byte[] bytes = StreamFixture.Load(name).Bytes;
        foreach (IEnumerable<ArraySegment<byte>> pieces in Splits.Of(bytes, splitting))
            AssertSame(Whole(bytes), await ReceiveAsync(BlockingOf(pieces.Select(static piece => piece.ToArray()))));
    }

    [Fact]
    public async Task The_buffer_grows_for_a_source_that_has_much()
    {
        byte[] bytes = TestPackets.Motions(0, 2000);
        PacketLog log = await ReceiveAsync(BlockingOf([bytes]));
        Same.Items(bytes, log.Packets.SelectMany(static packet => packet.Bytes));
    }

    private static BlockingStreamReceiver BlockingOf(IEnumerable<byte[]> pieces) => new(new FedStream().Feed([.. pieces]).End(), leaveOpen: false);

    private static PacketLog Whole(byte[] bytes)
    {
        var log = new PacketLog();
        var assembler = new PacketAssembler(new PacketScanner(), log);
        assembler.Push(bytes, 0);
        assembler.Abandon();
        return log;
    }

    private static async Task<PacketLog> ReceiveAsync(ByteReceiver receiver)
    {
        var log = new PacketLog();
        var assembler = new PacketAssembler(new PacketScanner(), log);
        await receiver.ReceiveAsync(assembler, new ReceiveGate()).Soon();
        Assert.Null(receiver.Failure);
        assembler.Abandon();
        receiver.Close();
        return log;
    }

    private static void AssertReceived(PacketLog log)
    {
        Same.Packets(Packets, log.Packets.Select(static packet => packet.Bytes));
        Assert.Equal(2 * Noise.Length, log.Skipped);
    }

    private static void AssertSame(PacketLog expected, PacketLog log)
    {
        Same.Packets(expected.Packets.Select(static packet => packet.Bytes), log.Packets.Select(static packet => packet.Bytes));
        Assert.Equal((expected.Skipped, expected.Text), (log.Skipped, log.Text));
    }
}
