using NeuronMocap.Protocol;

namespace NeuronMocap.Tests.Protocol;

/// <summary>Generated streams, read by <see cref="PacketAssembler"/> and by <see cref="ReferenceScanner"/>.</summary>
public sealed class PacketScannerPropertyTests
{
    private static readonly byte[] TokenBytes = [0xFF, 0xFF, 0xFF, 0xDD, 0xEE, 0x88, 0x99, 0xAA, 0xBB, 0x00, 0x01, 0x02];

    private readonly PacketScanner _scanner = new(WireStream.MaxValues);

    [Fact]
    public void Any_stream_in_any_pieces_matches_the_reference_reader()
    {
        int packets = 0;
        int refused = 0;
        int pending = 0;
        Properties.Hold(WireStream.Any, stream => stream.Simpler(), count: 4_000, stream =>
        {
            byte[] bytes = stream.ToBytes();
            ReferenceReading expected = ReferenceScanner.Read(bytes, WireStream.MaxValues);
            packets += expected.Packets.Count;
            refused += expected.Trace.Count - expected.Packets.Count - 1;
            pending += expected.Pending > 0 ? 1 : 0;

            Same.Items(expected.Trace, StreamTrace.OfAssembler(bytes, [new ArraySegment<byte>(bytes)], _scanner));
            Same.Items(expected.Trace, StreamTrace.OfAssembler(bytes, stream.Cut(bytes), _scanner));
            if (bytes.Length < 10_000)
                Same.Items(expected.Trace, StreamTrace.OfAssembler(bytes, Splits.Of(bytes, Splitting.ByteByByte).Single(), _scanner));
        });

        Assert.True(
            packets > Trials.Fewest(10_000) && refused > Trials.Fewest(3_300) && pending > Trials.Fewest(660),
            $"{packets} packets, {refused} refused headers, {pending} open ends: the streams are too poor to prove anything.");
    }

    // Only whole packets, so that skips cannot hide a fault.
    [Fact]
    public void Every_whole_packet_that_arrives_is_delivered() =>
        Properties.Hold(WireStream.OfWholePackets, stream => stream.Simpler(), count: 1_000, stream =>
        {
            var delivered = ScanAll.Of(stream.Cut(stream.ToBytes()), _scanner);
            Same.Packets(stream.Parts.Select(part => part.ToBytes()), delivered.Packets.Select(packet => packet.Bytes));
            Assert.Equal(0, delivered.Pending);
        });

    [Theory]
    [InlineData(1, false)]
    [InlineData(2, false)]
    [InlineData(3, true)]
    [InlineData(4, true)]
    public void Megabytes_of_garbage_never_throw_and_always_advance(int seed, bool tokenRich)
    {
        var random = new Random(seed);
        byte[] garbage = new byte[1 << 20];
        random.NextBytes(garbage);
        if (tokenRich)
        {
            for (int i = 0; i < garbage.Length; i++)
                garbage[i] = TokenBytes[garbage[i] % TokenBytes.Length];
        }

        var scan = ScanAll.Of(Splits.Random(garbage, random), new PacketScanner(1_000_000));

        Assert.Equal(garbage.Length, scan.Packets.Sum(packet => (long)packet.Bytes.Length) + scan.Skipped + scan.Pending);
    }
}
