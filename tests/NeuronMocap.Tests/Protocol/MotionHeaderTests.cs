namespace NeuronMocap.Tests.Protocol;

public sealed class MotionHeaderTests
{
    [Fact]
    public void Every_field_of_the_new_layout_is_read()
    {
        Assert.True(MotionHeader.TryRead(GoldenPackets.Get("new").ByHand, out MotionHeader header));

        Assert.Equal(HeaderLayout.New, header.Layout);
        Assert.Equal(new DataVersion(1, 1, 0, 0), header.Version);
        Assert.Equal(3, header.ValueCount);
        Assert.Equal(76, header.PacketSize);
        Assert.True(header.HasDisplacement);
        Assert.False(header.HasReference);
        Assert.Equal(258, header.AvatarIndex);
        Assert.Equal("Char00", header.AvatarName.ToString());
        Assert.Equal(0x12345678u, header.FrameIndex);
        Assert.Equal((1u, 2u, 0x80000003u), (header.Reserved, header.Reserved1, header.Reserved2));
    }

    [Fact]
    public void Every_field_of_the_old_layout_is_read()
    {
        Assert.True(MotionHeader.TryRead(GoldenPackets.Get("old").ByHand, out MotionHeader header));

        Assert.Equal(HeaderLayout.Old, header.Layout);
        Assert.Equal(new DataVersion(1, 0, 0, 2), header.Version);
        Assert.Equal(2, header.ValueCount);
        Assert.True(header.HasDisplacement);
        Assert.True(header.HasReference);
        Assert.Equal(5, header.AvatarIndex);
        Assert.Equal("Old", header.AvatarName.ToString());
        Assert.Null(header.FrameIndex);
        Assert.Equal((0u, 1u, 0xDEADBEEFu), (header.Reserved, header.Reserved1, header.Reserved2));
    }

    [Fact]
    public void Reserved_fields_are_kept()
    {
        Assert.True(MotionHeader.TryRead(GoldenPackets.Get("studio").ByHand, out MotionHeader header));

        Assert.Equal("1.1.0.1", header.Version.ToString());
        Assert.Equal("演员一", header.AvatarName.ToString());
        Assert.False(header.HasDisplacement);
        Assert.True(header.HasReference);
        Assert.Equal(uint.MaxValue, header.FrameIndex);
        Assert.Equal((1u, 0x000A0B0Cu, 7u), (header.Reserved, header.Reserved1, header.Reserved2));
    }

    [Theory]
    [InlineData("new")]
    [InlineData("studio")]
    [InlineData("old")]
    public void A_header_round_trips_byte_for_byte(string name)
    {
        byte[] packet = GoldenPackets.Get(name).ByHand;
        Assert.True(MotionHeader.TryRead(packet, out MotionHeader header));

        byte[] written = Filled(64);
        header.Write(written);

        Assert.Equal(Convert.ToHexString(packet.AsSpan(0, 64)), Convert.ToHexString(written));
    }

    [Theory]
    [InlineData("new")]
    [InlineData("studio")]
    [InlineData("old")]
    public void No_truncated_header_is_read(string name)
    {
        byte[] packet = GoldenPackets.Get(name).ByHand;
        for (int length = 0; length < 64; length++)
            Assert.False(MotionHeader.TryRead(packet.AsSpan(0, length), out _), $"{length} bytes were taken for a header.");

        Assert.True(MotionHeader.TryRead(packet.AsSpan(0, 64), out _));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(62)]
    [InlineData(63)]
    public void A_header_with_a_wrong_token_byte_is_not_read(int offset)
    {
        byte[] packet = GoldenPackets.Get("new").ByHand;
        packet[offset] ^= 0x01;
        Assert.False(MotionHeader.TryRead(packet, out _));
    }

    [Theory]
    [InlineData("calculation")]
    [InlineData("command")]
    public void A_header_of_another_kind_is_not_read(string name) =>
        Assert.False(MotionHeader.TryRead(GoldenPackets.Get(name).ByHand, out _));

    [Theory]
    [InlineData(1, 0, 0, 0, HeaderLayout.Old)]
    [InlineData(1, 0, 9, 9, HeaderLayout.Old)]
    [InlineData(1, 1, 0, 0, HeaderLayout.New)]
    [InlineData(1, 1, 0, 1, HeaderLayout.New)]
    [InlineData(1, 1, 9, 9, HeaderLayout.New)]
    [InlineData(1, 1, 255, 255, HeaderLayout.New)]
    public void Major_and_minor_alone_decide_the_layout(byte major, byte minor, byte revision, byte build, HeaderLayout expected)
    {
        byte[] packet = GoldenPackets.Get("new").ByHand;
        (packet[2], packet[3], packet[4], packet[5]) = (build, revision, minor, major);
        packet[8] = 0; // the high half of an old count

        Assert.True(MotionHeader.TryRead(packet, out MotionHeader header));
        Assert.Equal(expected, header.Layout);
        Assert.Equal(new DataVersion(major, minor, revision, build), header.Version);
    }

    [Theory]
    [InlineData(2, 0)]
    [InlineData(2, 1)]
    [InlineData(0, 0)]
    [InlineData(0, 1)]
    [InlineData(1, 2)]
    [InlineData(255, 255)]
    public void A_header_of_an_unknown_version_is_not_read(byte major, byte minor)
    {
        byte[] packet = GoldenPackets.Get("new").ByHand;
        (packet[4], packet[5]) = (minor, major);

        Assert.False(MotionHeader.TryRead(packet, out _));
        Assert.False(new DataVersion(major, minor, 0, 0).TryGetLayout(out _));
    }

    [Fact]
    public void Any_nonzero_byte_sets_a_flag_of_the_new_layout()
    {
        byte[] packet = GoldenPackets.Get("new").ByHand;
        (packet[8], packet[9]) = (0x80, 0xFF);

        Assert.True(MotionHeader.TryRead(packet, out MotionHeader header));
        Assert.True(header.HasDisplacement);
        Assert.True(header.HasReference);
    }

    [Fact]
    public void The_count_of_the_new_layout_ends_at_65535()
    {
        byte[] header = new byte[64];
        new MotionHeader { ValueCount = 65_535 }.Write(header);

        Assert.True(MotionHeader.TryRead(header, out MotionHeader read));
        Assert.Equal(65_535, read.ValueCount);
        Assert.Throws<InvalidOperationException>(() => new MotionHeader { ValueCount = 65_536 }.Write(header));
        Assert.Throws<InvalidOperationException>(() => new MotionHeader { ValueCount = -1 }.Write(header));
    }

    [Fact]
    public void The_count_of_the_old_layout_has_32_bits()
    {
        byte[] header = new byte[64];
        new MotionHeader { Version = DataVersion.Old, ValueCount = 65_536 }.Write(header);

        Assert.True(MotionHeader.TryRead(header, out MotionHeader read));
        Assert.Equal(65_536, read.ValueCount);
        Assert.Throws<InvalidOperationException>(() => new MotionHeader { Version = DataVersion.Old, ValueCount = -1 }.Write(header));
    }

    [Theory]
    [InlineData(PacketKind.Motion)]
    [InlineData(PacketKind.Calculation)]
    public void A_count_over_the_array_limit_is_not_read(PacketKind kind)
    {
        Assert.True(TryReadSize(kind, 536_870_895, out int largest));
        Assert.Equal(int.MaxValue - 3, largest);
        Assert.False(TryReadSize(kind, 536_870_896, out _));
        Assert.False(TryReadSize(kind, int.MaxValue, out _));
        Assert.False(TryReadSize(kind, 4_000_000_000, out _));
        Assert.False(TryReadSize(kind, uint.MaxValue, out _));
    }

    [Theory]
    [InlineData(0, 2)]
    [InlineData(2, 0)]
    [InlineData(0, 1)]
    [InlineData(1, 7)]
    public void A_header_of_an_unknown_version_round_trips(byte major, byte minor)
    {
        var header = new MotionHeader
        {
            Version = new DataVersion(major, minor, 0, 0),
            ValueCount = 2,
            HasDisplacement = true,
            AvatarIndex = 9,
            FrameIndex = 11,
        };
        byte[] bytes = new byte[64];
        header.Write(bytes);

        Assert.Equal(HeaderLayout.New, header.Layout);
        Assert.Equal(header, MotionHeader.Read(bytes));
    }

    [Fact]
    public void A_missing_frame_index_is_written_as_zero()
    {
        byte[] bytes = Filled(64);
        new MotionHeader().Write(bytes);
        Assert.Equal("00000000", Convert.ToHexString(bytes.AsSpan(46, 4)));
    }

    [Fact]
    public void A_destination_below_64_bytes_is_refused() =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new MotionHeader().Write(new byte[63]));

    private static bool TryReadSize(PacketKind kind, uint count, out int size)
    {
        byte[] bytes = GoldenPackets.HeaderAnnouncing(kind, count);
        if (kind == PacketKind.Motion)
        {
            bool isMotion = MotionHeader.TryRead(bytes, out MotionHeader motion);
            size = motion.PacketSize;
            return isMotion;
        }

        bool isCalculation = CalculationHeader.TryRead(bytes, out CalculationHeader calculation);
        size = calculation.PacketSize;
        return isCalculation;
    }

    private static byte[] Filled(int size)
    {
        byte[] bytes = new byte[size];
        bytes.AsSpan().Fill(0xCC);
        return bytes;
    }
}
