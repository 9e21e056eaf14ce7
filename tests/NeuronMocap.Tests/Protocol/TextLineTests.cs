using System.Globalization;
using System.Text;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;
using static NeuronMocap.Tests.Protocol.TextReading;

namespace NeuronMocap.Tests.Protocol;

/// <summary>The number, name and values of a line of text. Each case is read whole and byte by byte.</summary>
public sealed class TextLineTests
{
    [Theory]
    [InlineData(180, PacketKind.Motion, false, false)]
    [InlineData(186, PacketKind.Motion, false, true)]
    [InlineData(354, PacketKind.Motion, true, false)]
    [InlineData(360, PacketKind.Motion, true, true)]
    [InlineData(338, PacketKind.Calculation, false, false)]
    [InlineData(946, PacketKind.Calculation, false, false)]
    public void The_value_count_decides_the_kind_of_line(int count, PacketKind kind, bool displacement, bool reference)
    {
        PacketLog log = Read(Line(2, count, "||\r\n", lead: "3 Tänzer "));
        (PacketKind found, byte[] image, _) = Assert.Single(log.Packets);
        Assert.Equal(kind, found);
        Assert.Equal(count, ValuesOf(image).Length);
        Assert.Equal(0, image[62] | image[63]);
        if (kind == PacketKind.Motion)
        {
            var header = MotionHeader.Read(image);
            Assert.Equal((DataVersion.None, 3, "Tänzer", displacement, reference), (header.Version, header.AvatarIndex, header.AvatarName.ToString(), header.HasDisplacement, header.HasReference));
            Assert.False(MotionHeader.TryRead(image, out _));
        }
        else
        {
            var header = CalculationHeader.Read(image);
            Assert.Equal((DataVersion.None, 3, "Tänzer"), (header.Version, header.AvatarIndex, header.AvatarName.ToString()));
        }
    }

    [Theory]
    [InlineData(338, " ")]
    [InlineData(946, " ")]
    [InlineData(946, "\t")]
    [InlineData(946, " \t ")]
    public void Calculation_columns_need_no_number_or_name(int count, string separator)
    {
        PacketLog log = Read(Line(2, count, "\n", lead: "", separator));
        (PacketKind kind, byte[] image, _) = Assert.Single(log.Packets);
        var header = CalculationHeader.Read(image);
        Assert.Equal((PacketKind.Calculation, 0, ""), (kind, header.AvatarIndex, header.AvatarName.ToString()));
        Assert.Equal(TestPackets.Value(2, 0, count - 1), ValuesOf(image)[^1]);
    }

    [Theory]
    [InlineData("7", "7")]
    [InlineData("-12.5", "-12.5")]
    [InlineData("7up", "7up")]
    [InlineData("nan", "nan")]
    [InlineData("演员一", "演员一")]
    [InlineData("演员一演员一演员一演员一", "演员一演员一演员一演")] // 36 bytes, of which 30 are ten whole letters
    public void Any_word_is_a_name(string name, string expected)
    {
        PacketLog log = Read(Line(1, 354, "||\r\n", lead: $"0 {name} ") + Line(2, 180, "||\r\n", lead: $"4294967295 {name} "));
        Assert.Equal([354, 180], log.Packets.Select(packet => ValuesOf(packet.Bytes).Length));
        Assert.Equal(expected, MotionHeader.Read(log.Packets[0].Bytes).AvatarName.ToString());
        Assert.Equal(-1, MotionHeader.Read(log.Packets[1].Bytes).AvatarIndex);
    }

    [Theory]
    [InlineData("Anna Lena", "Anna Lena")]
    [InlineData("Nancy de la  Cruz", "Nancy de la  Cruz")]
    [InlineData("Indy A|B\tC", "Indy A|B\tC")]
    [InlineData("A B C D E F G", "A B C D E F G")] // the words of a line of 186 values
    [InlineData("演员 一", "演员 一")]
    [InlineData("演员一 演员一 演员一 演员一", "演员一 演员一 演员一 ")]
    public void A_name_of_several_words_is_read_without_numbers(string name, string expected)
    {
        foreach (int count in (int[])[180, 186, 354, 360])
        {
            (_, byte[] image, _) = Assert.Single(Read(Line(1, count, "||\r\n", lead: $"3 {name} ")).Packets);
            Assert.Equal((expected, 3), (MotionHeader.Read(image).AvatarName.ToString(), MotionHeader.Read(image).AvatarIndex));
            Assert.Equal(TestPackets.Value(1, 0, count - 1), ValuesOf(image)[^1]);
        }
    }

    [Theory]
    [InlineData("Char 02")]
    [InlineData("Player 1 of 2")]
    public void A_name_with_a_number_among_its_words_is_refused(string name)
    {
        PacketLog log = Read(Line(1, 354, "||\r\n", lead: $"0 {name} ") + Line(2, 354, "||\r\n"));
        Assert.Equal(2, ValuesOf(Assert.Single(log.Packets).Bytes)[0]);
        Assert.Contains(SkipReason.AmbiguousName, log.Reasons);
    }

    [Theory]
    [InlineData(180)]
    [InlineData(186)]
    [InlineData(354)]
    [InlineData(360)]
    public void A_line_without_an_avatar_is_refused(int count)
    {
        string values = string.Join(' ', Enumerable.Range(0, count).Select(static value => $"{value}.50"));
        PacketLog log = Read($"{values} ||\r\n" + Line(2, 354, "||\r\n"));
        Assert.Equal(2, ValuesOf(Assert.Single(log.Packets).Bytes)[0]);
        Assert.Contains(SkipReason.MissingAvatar, log.Reasons);
        Assert.DoesNotContain(SkipReason.MalformedLine, log.Reasons);
    }

    // The words of both lines do not form a name.
    [Fact]
    public void A_cut_line_does_not_take_the_next_as_its_name()
    {
        PacketLog log = Read("0 Anna Lena 1.00 2.00 " + Line(1, 354, "||\r\n", lead: "0 Anna Lena "));
        Assert.Empty(log.Packets);
    }

    [Theory]
    [InlineData("1.5", 1.5f)]
    [InlineData("-0.00", -0f)]
    [InlineData("+2", 2f)]
    [InlineData(".25", 0.25f)]
    [InlineData("-5.", -5f)]
    [InlineData("1e3", 1000f)]
    [InlineData("-2.5E-3", -0.0025f)]
    [InlineData("0,125", 0.125f)]
    [InlineData("-179,99", -179.99f)]
    [InlineData("93.0199966430664", 93.02f)]
    [InlineData("16777217", 16777216f)]
    [InlineData("1.00000017881393432617187499", 1.0000001f)]
    [InlineData("1e-46", 0f)]
    [InlineData("1e39", float.PositiveInfinity)]
    [InlineData("inf", float.PositiveInfinity)]
    [InlineData("-1.#INF00", float.NegativeInfinity)]
    [InlineData("nan", float.NaN)]
    [InlineData("-nan(ind)", float.NaN)]
    [InlineData("1.#QNAN", float.NaN)]
    [InlineData("-1.#IND", float.NaN)]
    public void Numbers_are_read_as_servers_write_them(string word, float expected)
    {
        float[] values = ValuesOf(Assert.Single(ReadWith(word).Packets).Bytes);
        Assert.Equal(BitConverter.SingleToInt32Bits(expected), BitConverter.SingleToInt32Bits(values[100]));
    }

    [Theory]
    [InlineData("1x")]
    [InlineData("--1")]
    [InlineData("1.5.2")]
    [InlineData("1,5,2")]
    [InlineData("1e")]
    [InlineData("-")]
    [InlineData("Char00")]
    [InlineData("0x10")]
    [InlineData("1.0;")]
    public void A_word_among_numbers_refuses_only_its_line(string word)
    {
        PacketLog log = ReadWith(word, behind: Line(9, 180, "||\r\n"));
        Assert.Equal(9, ValuesOf(Assert.Single(log.Packets).Bytes)[0]);
        Assert.Contains(SkipReason.MalformedLine, log.Reasons);
    }

    [Fact]
    public void The_culture_does_not_matter()
    {
        CultureInfo before = CultureInfo.CurrentCulture;
        var foreign = (CultureInfo)CultureInfo.InvariantCulture.Clone();
        (foreign.NumberFormat.NumberDecimalSeparator, foreign.NumberFormat.NumberGroupSeparator, foreign.NumberFormat.NegativeSign) = (",", ".", "~");
        try
        {
            CultureInfo.CurrentCulture = foreign;
            Assert.Equal(-1.25f, ValuesOf(Assert.Single(ReadWith("-1.25").Packets).Bytes)[100]);
            Assert.Equal(0.1f, ValuesOf(Assert.Single(ReadWith("0.1000000014901161193847656250").Packets).Bytes)[100]);
        }
        finally
        {
            CultureInfo.CurrentCulture = before;
        }
    }

    [Theory]
    [InlineData(353)]
    [InlineData(366)]
    [InlineData(1)]
    [InlineData(952)]
    public void A_line_of_another_count_is_refused_with_its_reason(int count)
    {
        string bad = Line(1, count, "||\r\n");
        PacketLog log = Read(Line(1, 354, "||\r\n") + bad + Line(2, 354, "||\r\n"));
        Assert.Equal([1, 2], log.Packets.Select(packet => (int)ValuesOf(packet.Bytes)[0]));
        Assert.Equal((bad.Length, 1), (log.Skipped, log.Reasons.Count(reason => reason == SkipReason.MalformedLine)));
    }

    [Theory]
    [InlineData("-1 Char00 ")]
    [InlineData("0.5 Char00 ")]
    [InlineData("4294967296 Char00 ")]
    public void An_avatars_number_is_a_whole_number(string lead)
    {
        PacketLog log = Read(Line(1, 354, "||\r\n", lead));
        Assert.Empty(log.Packets);
        Assert.Contains(SkipReason.MalformedLine, log.Reasons);
    }

    [Fact]
    public void The_limit_of_values_applies_to_lines()
    {
        var log = new PacketLog();
        new PacketAssembler(new PacketScanner(maxValues: 353), log).Push(Encoding.UTF8.GetBytes(Line(1, 354, "||\r\n") + Line(2, 180, "||\r\n")), 0);
        Assert.Equal(2, ValuesOf(Assert.Single(log.Packets).Bytes)[0]);
        Assert.Contains(SkipReason.TooLarge, log.Reasons);
    }

    private static PacketLog ReadWith(string word, string behind = "")
    {
        string[] words = [.. Enumerable.Range(0, 180).Select(index => index == 100 ? word : "0.5")];
        return Read($"0 Char00 {string.Join(' ', words)} ||\r\n{behind}");
    }
}
