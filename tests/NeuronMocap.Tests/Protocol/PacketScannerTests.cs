using NeuronMocap.Protocol;

namespace NeuronMocap.Tests.Protocol;

public sealed class PacketScannerTests
{
    private static readonly byte[] First = GoldenPackets.NewMotion([1, 2, 3], frame: 1);
    private static readonly byte[] Second = GoldenPackets.OldMotion([4, 5], avatar: 2);
    private static readonly byte[] Third = GoldenPackets.CalculationData([6], frame: 3);

    [Theory, EverySplitting]
    public void Packets_back_to_back_come_out_in_order(Splitting splitting) =>
        AssertFound(splitting, [.. First, .. Second, .. Third, .. First], [First, Second, Third, First], skipped: 0);

    [Theory, EverySplitting]
    public void Noise_around_packets_is_skipped(Splitting splitting)
    {
        byte[] noise = [0x00, 0x01, 0xDD, 0xEE, 0x12, 0x88];
        AssertFound(splitting, [.. noise, .. First, .. noise, .. noise, .. Second, .. noise], [First, Second], skipped: 24);
    }

    [Theory, EverySplitting]
    public void A_first_token_without_its_second_is_noise(Splitting splitting)
    {
        byte[] header = First[..64];
        header[63] = 0xEF;
        AssertFound(splitting, [.. header, .. Second], [Second], skipped: 64);
    }

    [Theory, EverySplitting]
    public void The_second_token_of_another_kind_does_not_close_a_header(Splitting splitting)
    {
        byte[] header = First[..64];
        header[63] = 0x99;
        AssertFound(splitting, [.. header, .. Second], [Second], skipped: 64);
    }

    [Theory, EverySplitting]
    public void A_single_FF_before_a_packet_does_not_hide_it(Splitting splitting) =>
        AssertFound(splitting, [0xFF, .. First, 0xFF, .. Second], [First, Second], skipped: 2);

    [Theory, EverySplitting]
    public void Runs_of_FF_do_not_hide_a_packet(Splitting splitting)
    {
        byte[] run = [.. Enumerable.Repeat((byte)0xFF, 200)];
        AssertFound(splitting, [.. run, .. First, .. run, .. Second], [First, Second], skipped: 400);
    }

    [Theory, EverySplitting]
    public void Unordered_token_bytes_are_noise(Splitting splitting)
    {
        byte[] noise = new WireBytes().Hex("FF DD FF FF DD EE FF EE FF 88 FF 99 FF AA FF BB DD DD FF FF FF 88 99 AA BB EE FF DD").ToArray();
        AssertFound(splitting, [.. noise, .. First, .. noise, .. Third], [First, Third], skipped: 2 * noise.Length);
    }

    [Theory, EverySplitting]
    public void A_false_token_before_a_packet_does_not_hide_it(Splitting splitting) =>
        AssertFound(splitting, [0xFF, 0xDD, .. First, 0xFF, 0x88, .. Second, 0xFF, 0xAA, 0x00, .. Third], [First, Second, Third], skipped: 7);

    [Theory, EverySplitting]
    public void A_token_pair_among_the_values_belongs_to_the_packet(Splitting splitting)
    {
        byte[] packet = GoldenPackets.NewMotion(new float[40]);
        First.CopyTo(packet, 64 + 11);
        AssertFound(splitting, [.. packet, .. Second], [packet, Second], skipped: 0);
    }

    [Theory, EverySplitting]
    public void A_packet_whose_start_was_missed_is_skipped_up_to_the_next(Splitting splitting) =>
        AssertFound(splitting, [.. First[10..], .. Second], [Second], skipped: First.Length - 10);

    // The stream has neither length prefix nor checksum. The bytes that follow a header count as its payload, as in the vendor's library (protocol.md
    // section 5). The packet whose start is consumed in this way is lost. The packet after it is found.
    [Theory, EverySplitting]
    public void A_truncated_packet_consumes_bytes_of_the_next(Splitting splitting)
    {
        byte[] whole = GoldenPackets.NewMotion(new float[20]);
        byte[] truncated = whole[..^40];
        byte[] taken = [.. truncated, .. First[..40]];

        AssertFound(splitting, [.. truncated, .. First, .. Second, .. Third], [taken, Second, Third], skipped: First.Length - 40);
    }

    [Theory]
    [InlineData("00 00 00 02")]
    [InlineData("00 00 00 00")]
    [InlineData("00 00 01 00")]
    [InlineData("00 00 02 01")]
    [InlineData("FF FF FF FF")]
    public void A_motion_packet_of_an_unknown_version_is_skipped_for_that_reason(string version)
    {
        byte[] unknown = GoldenPackets.NewMotion([1, 2, 3], version: version);
        foreach (Splitting splitting in Enum.GetValues<Splitting>())
            AssertFound(splitting, [.. First, .. unknown, .. Second], [First, Second], skipped: unknown.Length, unknownVersions: 1);
    }

    [Theory]
    [InlineData("01 00 01 01")]
    [InlineData("09 09 01 01")]
    public void Revision_and_build_are_ignored(string version)
    {
        byte[] packet = GoldenPackets.NewMotion([1], version: version);
        AssertFound(Splitting.Whole, packet, [packet], skipped: 0);
    }

    [Theory, EverySplitting]
    public void A_packet_of_no_values_is_a_whole_packet_of_64_bytes(Splitting splitting)
    {
        byte[] motion = GoldenPackets.NewMotion([]);
        byte[] calculation = GoldenPackets.CalculationData([]);
        byte[] command = GoldenPackets.OldCommand(command: 4, count: 0, payload: 0);
        AssertFound(splitting, [.. motion, .. calculation, .. command, .. First], [motion, calculation, command, First], skipped: 0);
    }

    [Theory, EverySplitting]
    public void Commands_have_the_length_of_their_id_and_count(Splitting splitting)
    {
        byte[] sizes = GoldenPackets.OldCommand(command: 0, count: 2, payload: 128);
        byte[] text = GoldenPackets.OldCommand(command: 4, count: 3, payload: 3);
        byte[] frequency = GoldenPackets.OldCommand(command: 3, count: 7, payload: 0);
        AssertFound(splitting, [.. sizes, .. text, .. frequency, .. First], [sizes, text, frequency, First], skipped: 0);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(354)]
    [InlineData(10_224)]
    public void The_limit_of_values_is_inclusive(int limit)
    {
        float[] values = new float[limit + 1];
        byte[][] allowed = [.. Kinds(values.AsSpan(1))];
        byte[][] tooLarge = [.. Kinds(values)];
        var scanner = new PacketScanner(limit);
        for (int i = 0; i < allowed.Length; i++)
        {
            var scan = ScanAll.Of([.. tooLarge[i], .. allowed[i]], scanner);

            Assert.Equal(allowed[i], Assert.Single(scan.Packets).Bytes);
            Assert.Equal(tooLarge[i].Length, scan.Skipped);
            Assert.Equal(1, scan.TooLarge);
        }
    }

    [Fact]
    public void The_default_limit_is_the_vendors()
    {
        byte[] largest = GoldenPackets.NewMotion(new float[10_224]);
        Assert.Equal(40_960, largest.Length);
        Assert.Equal(ScanStatus.Packet, new PacketScanner().Scan(largest).Status);
        Assert.Equal(SkipReason.TooLarge, new PacketScanner().Scan(GoldenPackets.NewMotion(new float[10_225])).Reason);
    }

    [Theory]
    [InlineData(PacketKind.Motion, 4_000_000_000)]
    [InlineData(PacketKind.Motion, uint.MaxValue)]
    [InlineData(PacketKind.Motion, 0x40000001)] // times four, this is four in 32 bits
    [InlineData(PacketKind.Motion, 0x80000000)]
    [InlineData(PacketKind.Calculation, 4_000_000_000)]
    [InlineData(PacketKind.Calculation, uint.MaxValue)]
    [InlineData(PacketKind.Calculation, 0x40000001)]
    public void A_count_of_billions_is_refused_on_the_header(PacketKind kind, uint count)
    {
        byte[] header = GoldenPackets.HeaderAnnouncing(kind, count);
        foreach (PacketScanner scanner in (PacketScanner[])[new(), new(1_000_000)])
        {
            ScanResult result = scanner.Scan(header);
            Assert.Equal((ScanStatus.Skipped, SkipReason.TooLarge), (result.Status, result.Reason));
        }
    }

    [Theory]
    [InlineData(0, 1_562u, 99_968, true)]
    [InlineData(0, 1_563u, 100_032, false)]
    [InlineData(0, uint.MaxValue, 0, false)]
    [InlineData(0, 0x04000001u, 64, false)] // times 64, this is 64 in 32 bits
    [InlineData(4, 100_000u, 100_000, true)]
    [InlineData(4, 100_001u, 100_001, false)]
    [InlineData(4, uint.MaxValue, 0, false)]
    public void A_commands_payload_is_limited_to_100000_bytes(int command, uint count, int payload, bool allowed)
    {
        byte[] packet = GoldenPackets.OldCommand(command, count, payload);
        ScanResult result = new PacketScanner(maxValues: 1).Scan(packet);

        if (allowed)
            Assert.Equal(new ScanResult(ScanStatus.Packet, packet.Length, PacketKind.Command), result);
        else
            Assert.Equal((ScanStatus.Skipped, SkipReason.TooLarge), (result.Status, result.Reason));
    }

    [Fact]
    public void A_packet_in_single_bytes_is_scanned_four_times()
    {
        byte[] packet = GoldenPackets.NewMotion(new float[354]);
        var scan = ScanAll.Of(Splits.Of(packet, Splitting.ByteByByte).Single());

        Assert.Equal(packet, Assert.Single(scan.Packets).Bytes);
        Assert.Equal([2, 64, 1480], scan.Waits);
        Assert.Equal(4, scan.Calls);
    }

    [Theory]
    [InlineData(0, 1)]
    [InlineData(1, 2)]
    [InlineData(2, 64)]
    [InlineData(63, 64)]
    [InlineData(64, 76)]
    [InlineData(75, 76)]
    public void The_needed_length_grows_from_token_to_header_to_packet(int given, int asked) =>
        Assert.Equal(new ScanResult(ScanStatus.NeedMoreData, asked), new PacketScanner().Scan(First.AsSpan(0, given)));

    [Fact]
    public void Bytes_after_the_packet_are_ignored()
    {
        ScanResult result = new PacketScanner().Scan([.. First, 0xFF, 0x00]);
        Assert.Equal(new ScanResult(ScanStatus.Packet, First.Length, PacketKind.Motion), result);
    }

    [Theory]
    [InlineData(int.MinValue)]
    [InlineData(-1)]
    [InlineData(0)]
    [InlineData(1_000_001)]
    public void A_limit_outside_its_range_is_refused(int maxValues) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new PacketScanner(maxValues));

    private static IEnumerable<byte[]> Kinds(ReadOnlySpan<float> values) =>
        [GoldenPackets.NewMotion(values), GoldenPackets.OldMotion(values), GoldenPackets.CalculationData(values)];

    private static void AssertFound(Splitting splitting, byte[] stream, byte[][] packets, long skipped, int unknownVersions = 0)
    {
        foreach (IEnumerable<ArraySegment<byte>> pieces in Splits.Of(stream, splitting))
        {
            var scan = ScanAll.Of(pieces);

            Same.Packets(packets, scan.Packets.Select(packet => packet.Bytes));
            Assert.Equal(skipped, scan.Skipped);
            Assert.Equal(unknownVersions, scan.UnknownVersions);
            Assert.Equal(0, scan.Pending);
        }
    }
}
