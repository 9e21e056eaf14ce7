using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Transport;

public sealed class PacketAssemblerTests
{
    // Noise that resembles tokens, between packets of both kinds and a packet without values.
    private static readonly byte[] Noise = [0xFF, 0xDD, 1, 2, 3, 0xFF, 0xFF, 0x88, 0xFF];

    private static readonly byte[][] Expected =
    [
        TestPackets.Motion(1, count: 180),
        TestPackets.Motion(2, layout: HeaderLayout.Old, count: 3),
        TestPackets.Calculation(3, count: 7),
        TestPackets.Motion(4, count: 0),
        TestPackets.Motion(5, count: 9),
    ];

    private static readonly byte[] Stream =
        [.. Noise, .. Expected[0], .. Expected[1], .. Noise, .. Noise, .. Expected[2], .. Expected[3], .. Noise, .. Expected[4]];

    [Fact]
    public void Every_split_in_two_gives_the_same_packets_and_skips()
    {
        for (int split = 0; split <= Stream.Length; split++)
            AssertDelivered([Stream[..split], Stream[split..]]);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(63)]
    [InlineData(64)]
    [InlineData(65)]
    [InlineData(100_000)]
    public void Pieces_of_any_size_give_the_same_packets_and_skips(int size) => AssertDelivered(Stream.Chunk(size));

    [Fact]
    public void Pieces_of_random_sizes_give_the_same_packets_and_skips()
    {
        var random = new Random(1);
        for (int round = 0; round < 500; round++)
        {
            List<byte[]> pieces = [];
            for (int start = 0; start < Stream.Length;)
            {
                int size = Math.Min(random.Next(0, 200), Stream.Length - start);
                pieces.Add(Stream[start..(start + size)]);
                start += size;
            }

            AssertDelivered(pieces);
        }
    }

    [Fact]
    public void An_unfinished_packet_can_be_abandoned_and_is_counted()
    {
        var log = new PacketLog();
        var assembler = new PacketAssembler(new PacketScanner(), log);
        assembler.Push(Expected[0][..700], 0);
        Assert.Equal(700, assembler.PendingBytes);
        assembler.Abandon();
        assembler.Abandon();
        assembler.Push(Expected[4], 0);

        Assert.Equal(Expected[4], Assert.Single(log.Packets).Bytes);
        Assert.Equal(700, log.Skipped);
        Assert.Equal([SkipReason.Incomplete], log.Reasons);
    }

    [Fact]
    public void An_oversized_header_is_skipped_before_buffering()
    {
        var log = new PacketLog();
        var assembler = new PacketAssembler(new PacketScanner(maxValues: 354), log);
        byte[] hostile = TestPackets.Calculation(1, count: 0);
        hostile.AsSpan(6, 4).Fill(0xFF);
        assembler.Push(hostile, 0);
        assembler.Push(TestPackets.Motion(2), 0);

        Assert.Single(log.Packets);
        Assert.Equal(64, log.Skipped);
        Assert.Contains(SkipReason.TooLarge, log.Reasons);
        Assert.Equal(0, assembler.PendingBytes);
    }

    // Found by fuzzing: any 64 bytes allocated 100 KB here, for each sender up to the maximum.
    [Fact]
    public void Memory_follows_received_bytes_not_headers()
    {
        byte[] header = new byte[64];
        new DataCommandHeader { CommandId = DataCommandId.BvhText, DataCount = ProtocolConstants.MaxCommandPayload }.Write(header);
        byte[] payload = new byte[ProtocolConstants.MaxCommandPayload];
        var assembler = new PacketAssembler(new PacketScanner(), new PacketLog());
        new PacketAssembler(new PacketScanner(), new PacketLog()).Push(header, 0);

        long before = GC.GetAllocatedBytesForCurrentThread();
        assembler.Push(header, 0);
        assembler.Push(payload.AsMemory(0, 1000).ToArray(), 0);
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 1, 16_384);
        Assert.Equal(1064, assembler.PendingBytes);
    }

    private static void AssertDelivered(IEnumerable<byte[]> pieces)
    {
        var log = new PacketLog();
        var assembler = new PacketAssembler(new PacketScanner(), log);
        foreach (byte[] piece in pieces)
            assembler.Push(piece, 0);

        Same.Packets(Expected, log.Packets.Select(packet => packet.Bytes));
        Assert.Equal(4 * Noise.Length, log.Skipped);
        Assert.Equal(0, assembler.PendingBytes);
    }
}
