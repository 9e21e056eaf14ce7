using System.Text;

namespace NeuronMocap.Tests.Protocol;

public sealed class AvatarNameTests
{
    [Theory]
    [InlineData("")]
    [InlineData("a")]
    [InlineData("Char00")]
    [InlineData("演员一")]
    [InlineData("Zoë")]
    [InlineData("🕺")]
    [InlineData("abcdefghijklmnopqrstuvwxyz012345")]
    [InlineData("🕺🕺🕺🕺🕺🕺🕺🕺")]
    public void A_name_that_fits_round_trips(string text)
    {
        var name = new AvatarName(text);
        byte[] bytes = new byte[32];
        name.CopyTo(bytes);

        byte[] expected = new byte[32];
        Encoding.UTF8.GetBytes(text).CopyTo(expected, 0);
        Assert.Equal(expected, bytes);
        Assert.Equal(text, name.ToString());
        Assert.Equal(name, new AvatarName(bytes));
    }

    [Theory]
    [InlineData("abcdefghijklmnopqrstuvwxyz0123456", "abcdefghijklmnopqrstuvwxyz012345")]
    [InlineData("abcdefghijklmnopqrstuvwxyz01234é", "abcdefghijklmnopqrstuvwxyz01234")] // one byte of room for a letter of two
    [InlineData("一二三四五六七八九十一", "一二三四五六七八九十")] // ten letters of three bytes, two bytes left
    [InlineData("abcdefghijklmnopqrstuvwxyz012🕺", "abcdefghijklmnopqrstuvwxyz012")] // three bytes of room for a letter of four
    [InlineData("abcdefghijklmnopqrstuvwxyz0🕺🕺", "abcdefghijklmnopqrstuvwxyz0🕺")]
    [InlineData("🕺🕺🕺🕺🕺🕺🕺🕺🕺", "🕺🕺🕺🕺🕺🕺🕺🕺")]
    public void A_longer_name_is_cut_between_two_characters(string text, string expected) =>
        Assert.Equal(expected, new AvatarName(text).ToString());

    [Fact]
    public void A_very_long_name_is_cut() =>
        Assert.Equal(new string('x', 32), new AvatarName(new string('x', 100_000)).ToString());

    [Theory]
    [InlineData(29, 32)] // U+FFFD has three bytes and just fits
    [InlineData(30, 30)]
    [InlineData(31, 31)]
    public void Half_a_surrogate_pair_becomes_a_replacement_character_where_one_fits(int before, int expectedBytes)
    {
        string text = new AvatarName(new string('x', before) + "\uD83D").ToString();
        Assert.Equal(expectedBytes, Encoding.UTF8.GetByteCount(text));
        Assert.Equal(expectedBytes > before ? new string('x', before) + "\uFFFD" : new string('x', before), text);
    }

    [Fact]
    public void Bytes_that_are_not_UTF8_become_replacement_characters()
    {
        Assert.Equal("a\uFFFDb", new AvatarName([0x61, 0xFF, 0x62]).ToString());
        Assert.Equal("a\uFFFD", new AvatarName([0x61, 0xE6, 0xBC]).ToString());
    }

    [Fact]
    public void The_text_ends_at_the_first_zero_but_all_bytes_are_kept_and_compared()
    {
        var name = new AvatarName([0x61, 0x00, 0x62]);
        byte[] bytes = new byte[32];
        name.CopyTo(bytes);

        Assert.Equal("a", name.ToString());
        Assert.Equal(0x62, bytes[2]);
        Assert.NotEqual(new AvatarName("a"), name);
    }

    [Fact]
    public void A_name_has_at_most_32_bytes()
    {
        byte[] bytes = [.. Enumerable.Range(1, 33).Select(value => (byte)value)];
        byte[] copy = new byte[32];
        new AvatarName(bytes.AsSpan(0, 32)).CopyTo(copy);

        Assert.Equal(bytes[..32], copy);
        Assert.Throws<ArgumentException>(() => new AvatarName(bytes));
    }

    [Fact]
    public void A_null_name_is_refused() => Assert.Throws<ArgumentNullException>(() => new AvatarName((string)null!));

    [Fact]
    public void A_destination_below_32_bytes_is_refused() =>
        Assert.Throws<ArgumentException>(() => new AvatarName("a").CopyTo(new byte[31]));

    [Fact]
    public void Names_that_differ_in_any_one_byte_are_different()
    {
        byte[] bytes = new byte[32];
        var empty = new AvatarName(bytes);
        for (int i = 0; i < 32; i++)
        {
            bytes[i] = 1;
            var other = new AvatarName(bytes);
            bytes[i] = 0;

            Assert.True(other != empty, $"Byte {i} is not compared.");
            Assert.False(other == empty);
            Assert.False(other.Equals((object)empty));
        }

        Assert.Equal(new AvatarName("a").GetHashCode(), new AvatarName([0x61]).GetHashCode());
        Assert.Equal(default, empty);
    }
}
