namespace NeuronMocap.Tests.Protocol;

public sealed class CalculationHeaderTests
{
    [Fact]
    public void Every_field_is_read()
    {
        Assert.True(CalculationHeader.TryRead(GoldenPackets.Get("calculation").ByHand, out CalculationHeader header));

        Assert.Equal(new DataVersion(1, 0, 0, 3), header.Version);
        Assert.Equal(1, header.ValueCount);
        Assert.Equal(68, header.PacketSize);
        Assert.Equal(1, header.AvatarIndex);
        Assert.Equal("abcdefghijklmnopqrstuvwxyz012345", header.AvatarName.ToString());
        Assert.Equal(10u, header.FrameIndex);
        Assert.Equal((0x01020304u, 0x05060708u, 0x090A0B0Cu), (header.Reserved1, header.Reserved2, header.Reserved3));
    }

    [Fact]
    public void A_header_round_trips_byte_for_byte()
    {
        byte[] packet = GoldenPackets.Get("calculation").ByHand;
        Assert.True(CalculationHeader.TryRead(packet, out CalculationHeader header));

        byte[] written = new byte[64];
        written.AsSpan().Fill(0xCC);
        header.Write(written);

        Assert.Equal(Convert.ToHexString(packet.AsSpan(0, 64)), Convert.ToHexString(written));
    }

    [Fact]
    public void No_truncated_header_is_read()
    {
        byte[] packet = GoldenPackets.Get("calculation").ByHand;
        for (int length = 0; length < 64; length++)
            Assert.False(CalculationHeader.TryRead(packet.AsSpan(0, length), out _), $"{length} bytes were taken for a header.");

        Assert.True(CalculationHeader.TryRead(packet.AsSpan(0, 64), out _));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(62)]
    [InlineData(63)]
    public void A_header_with_a_wrong_token_byte_is_not_read(int offset)
    {
        byte[] packet = GoldenPackets.Get("calculation").ByHand;
        packet[offset] ^= 0x01;
        Assert.False(CalculationHeader.TryRead(packet, out _));
    }

    [Theory]
    [InlineData("new")]
    [InlineData("old")]
    [InlineData("command")]
    public void A_header_of_another_kind_is_not_read(string name) =>
        Assert.False(CalculationHeader.TryRead(GoldenPackets.Get(name).ByHand, out _));

    [Theory]
    [InlineData(0, 0, 0, 0)]
    [InlineData(2, 0, 0, 0)]
    [InlineData(255, 255, 255, 255)]
    public void Any_version_is_read(byte major, byte minor, byte revision, byte build)
    {
        byte[] packet = GoldenPackets.Get("calculation").ByHand;
        (packet[2], packet[3], packet[4], packet[5]) = (build, revision, minor, major);

        Assert.True(CalculationHeader.TryRead(packet, out CalculationHeader header));
        Assert.Equal(new DataVersion(major, minor, revision, build), header.Version);
    }

    [Fact]
    public void A_negative_count_is_not_written() =>
        Assert.Throws<InvalidOperationException>(() => new CalculationHeader { ValueCount = -1 }.Write(new byte[64]));

    [Fact]
    public void A_destination_below_64_bytes_is_refused() =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new CalculationHeader().Write(new byte[63]));
}
