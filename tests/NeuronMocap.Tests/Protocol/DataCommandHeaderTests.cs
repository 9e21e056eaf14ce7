using NeuronMocap.Protocol;

namespace NeuronMocap.Tests.Protocol;

public sealed class DataCommandHeaderTests
{
    [Fact]
    public void Every_field_is_read()
    {
        Assert.True(DataCommandHeader.TryRead(GoldenPackets.Get("command").ByHand, out DataCommandHeader header));

        Assert.Equal(new DataVersion(1, 0, 0, 2), header.Version);
        Assert.Equal(DataCommandId.BvhText, header.CommandId);
        Assert.Equal(5u, header.DataCount);
        Assert.Equal(5, header.PayloadSize);
    }

    [Theory]
    [InlineData(0, 3u, 192)]
    [InlineData(0, uint.MaxValue, 274_877_906_880)]
    [InlineData(1, 3u, 0)]
    [InlineData(2, 3u, 0)]
    [InlineData(3, 3u, 0)]
    [InlineData(4, 3u, 3)]
    [InlineData(4, uint.MaxValue, 4_294_967_295)]
    [InlineData(5, 3u, 0)]
    [InlineData(8, 3u, 0)]
    [InlineData(-1, 3u, 0)]
    public void Command_and_count_give_the_payload(int command, uint count, long expected) =>
        Assert.Equal(expected, new DataCommandHeader { CommandId = (DataCommandId)command, DataCount = count }.PayloadSize);

    [Fact]
    public void No_truncated_header_is_read()
    {
        byte[] packet = GoldenPackets.Get("command").ByHand;
        for (int length = 0; length < 64; length++)
            Assert.False(DataCommandHeader.TryRead(packet.AsSpan(0, length), out _), $"{length} bytes were taken for a header.");

        Assert.True(DataCommandHeader.TryRead(packet.AsSpan(0, 64), out _));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(62)]
    [InlineData(63)]
    public void A_header_with_a_wrong_token_byte_is_not_read(int offset)
    {
        byte[] packet = GoldenPackets.Get("command").ByHand;
        packet[offset] ^= 0x01;
        Assert.False(DataCommandHeader.TryRead(packet, out _));
    }

    [Fact]
    public void A_request_is_written_as_the_vendors_library_sends_it()
    {
        byte[] written = new byte[64];
        written.AsSpan().Fill(0xCC);
        new DataCommandHeader { CommandId = DataCommandId.AvatarCount }.Write(written);

        Assert.Equal(Convert.ToHexString(GoldenPackets.OldCommand(command: 5, count: 0, payload: 0)), Convert.ToHexString(written));
    }

    // Offsets 18 and 22 as in protocol.md section 2.6, written by hand.
    [Fact]
    public void The_two_known_parameters_start_the_40_bytes()
    {
        byte[] packet = GoldenPackets.OldCommand(command: 3, count: 0, payload: 0);
        new byte[] { 0x02, 0, 0, 0, 0x78, 0, 0, 0 }.CopyTo(packet.AsSpan(18));

        Assert.True(DataCommandHeader.TryRead(packet, out DataCommandHeader header));
        Assert.Equal(2, header.Parameter);
        Assert.Equal(120, header.Value);

        byte[] written = new byte[64];
        header.Write(written);
        Assert.Equal(Convert.ToHexString(packet), Convert.ToHexString(written));
    }

    [Fact]
    public void A_destination_below_64_bytes_is_refused() =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new DataCommandHeader().Write(new byte[63]));
}
