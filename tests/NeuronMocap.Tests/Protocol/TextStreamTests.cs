using System.Globalization;
using System.Runtime.InteropServices;
using System.Text;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Protocol;

/// <summary>Lines of text through <see cref="PacketAssembler"/>, each case whole and byte by byte.</summary>
public sealed class TextStreamTests
{
    [Theory]
    [InlineData(" ||\r\n")]
    [InlineData("||\r\n")]
    [InlineData("||\n")]
    [InlineData("\r\n")]
    [InlineData(" \n")]
    [InlineData("||")]
    [InlineData(" || \0\0")]
    [InlineData(" |\r\n")]
    public void A_line_ends_with_bars_or_a_line_feed(string end)
    {
        string[] lines = [.. Enumerable.Range(0, 3).Select(frame => Line(frame, 180, end))];
        PacketLog log = Read(string.Concat(lines));
        Assert.Equal([0, 1, 2], log.Packets.Select(packet => (int)ValuesOf(packet.Bytes)[0]));
        Assert.Equal((0, lines.Sum(line => line.Length)), (log.Skipped, log.Text));
    }

    [Theory]
    [InlineData("||", 2)]
    [InlineData("\n", 1)]
    [InlineData("\r\n", 2)]
    public void A_line_is_delivered_with_the_byte_that_ends_it(string end, int endLength)
    {
        byte[] line = Encoding.UTF8.GetBytes(Line(5, 354, end));
        var log = new PacketLog();
        var assembler = new PacketAssembler(new PacketScanner(), log);
        for (int i = 0; i < line.Length - 1; i++)
            assembler.Push(new ArraySegment<byte>(line, i, 1), timestamp: 0);

        Assert.Empty(log.Packets);
        Assert.Equal(line.Length - 1, assembler.PendingBytes);
        assembler.Push(new ArraySegment<byte>(line, line.Length - 1, 1), timestamp: 7);
        Assert.Single(log.Packets);
        Assert.True(endLength > 0);
    }

    [Theory]
    [InlineData(180, PacketKind.Motion, false, false)]
    [InlineData(186, PacketKind.Motion, false, true)]
    [InlineData(354, PacketKind.Motion, true, false)]
    [InlineData(360, PacketKind.Motion, true, true)]
    [InlineData(338, PacketKind.Calculation, false, false)]
    [InlineData(946, PacketKind.Calculation, false, false)]
    public void The_number_of_values_says_what_a_line_is(int count, PacketKind kind, bool displacement, bool reference)
    {
        PacketLog log = Read(Line(2, count, "||\r\n", lead: "3 Tänzer "));
        (PacketKind found, byte[] image, _) = Assert.Single(log.Packets);
        Assert.Equal(kind, found);
        Assert.Equal(count, ValuesOf(image).Length);
        Assert.Equal(0, image[62] | image[63]);
        if (kind == PacketKind.Motion)
        {
            var header = MotionHeader.Read(image);
            Assert.Equal((DataVersion.None, 3u, "Tänzer", displacement, reference), (header.Version, header.AvatarIndex, header.AvatarName.ToString(), header.HasDisplacement, header.HasReference));
            Assert.False(MotionHeader.TryRead(image, out _));
        }
        else
        {
            var header = CalculationHeader.Read(image);
            Assert.Equal((DataVersion.None, 3u, "Tänzer"), (header.Version, header.AvatarIndex, header.AvatarName.ToString()));
        }
    }

    [Theory]
    [InlineData(338, " ")]
    [InlineData(946, " ")]
    [InlineData(946, "\t")]
    [InlineData(946, " \t ")]
    public void Columns_of_calculation_data_need_neither_number_nor_name(int count, string separator)
    {
        PacketLog log = Read(Line(2, count, "\n", lead: "", separator));
        (PacketKind kind, byte[] image, _) = Assert.Single(log.Packets);
        var header = CalculationHeader.Read(image);
        Assert.Equal((PacketKind.Calculation, 0u, ""), (kind, header.AvatarIndex, header.AvatarName.ToString()));
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
        Assert.Equal(uint.MaxValue, MotionHeader.Read(log.Packets[1].Bytes).AvatarIndex);
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
    public void A_line_with_a_word_that_is_no_number_is_refused_and_the_next_is_not(string word)
    {
        PacketLog log = ReadWith(word, behind: Line(9, 180, "||\r\n"));
        Assert.Equal(9, ValuesOf(Assert.Single(log.Packets).Bytes)[0]);
        Assert.Contains(SkipReason.MalformedLine, log.Reasons);
    }

    [Fact]
    public void The_culture_changes_nothing()
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
    [InlineData(355)]
    [InlineData(1)]
    [InlineData(948)]
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
    public void A_limit_of_values_holds_for_lines_too()
    {
        var log = new PacketLog();
        new PacketAssembler(new PacketScanner(maxValues: 353), log).Push(Encoding.UTF8.GetBytes(Line(1, 354, "||\r\n") + Line(2, 180, "||\r\n")), 0);
        Assert.Equal(2, ValuesOf(Assert.Single(log.Packets).Bytes)[0]);
        Assert.Contains(SkipReason.TooLarge, log.Reasons);
    }

    [Fact]
    public void Zero_bytes_count_for_nothing_wherever_they_stand()
    {
        string line = Line(6, 180, " ||\r\n");
        PacketLog log = Read(line[..9] + "\0" + line[9..100] + "\0\0" + line[100..] + "\0\0\0" + line);
        Assert.Equal(2, log.Packets.Count);
        Assert.Equal(log.Packets[1].Bytes, log.Packets[0].Bytes);
        Assert.Equal(0, log.Skipped);
    }

    // A stream that is joined in the middle of a line.
    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    [InlineData(9)]
    [InlineData(500)]
    [InlineData(1_000)]
    public void The_rest_of_a_line_is_skipped_and_the_next_line_is_not(int missed)
    {
        string line = Line(1, 354, " ||\r\n");
        PacketLog log = Read(line[missed..] + Line(2, 354, " ||\r\n"));
        Assert.Equal(2, ValuesOf(log.Packets[^1].Bytes)[0]);
        Assert.Single(log.Packets);
    }

    // Of 360 values the last 356 words could be the number, the name and the values of a line of 354.
    [Fact]
    public void A_sender_that_is_heard_late_gets_no_frame_from_the_rest_of_a_line()
    {
        string line = "0 Char00 1 2 3 4 " + Line(1, 354, " ||\r\n", lead: "5 6 ");
        string rest = line[(line.IndexOf(" 5 6 ", StringComparison.Ordinal) + 1)..];
        var log = new PacketLog();
        var assembler = new PacketAssembler(new PacketScanner(), log);
        assembler.JoinLate();
        assembler.Push(Encoding.UTF8.GetBytes(rest), timestamp: 0);
        Assert.Empty(log.Packets);
        Assert.All(log.Reasons, reason => Assert.Equal(SkipReason.NoTokens, reason));

        assembler.Push(Encoding.UTF8.GetBytes(rest), timestamp: 0);
        Assert.Single(log.Packets);
    }

    [Fact]
    public void A_sender_that_is_heard_late_is_read_from_its_first_named_line()
    {
        var log = new PacketLog();
        var assembler = new PacketAssembler(new PacketScanner(), log);
        assembler.JoinLate();
        assembler.Push(Encoding.UTF8.GetBytes(Line(1, 354, " ||\r\n")), timestamp: 0);
        Assert.Single(log.Packets);
    }

    [Fact]
    public void Packets_and_lines_take_turns_on_one_connection()
    {
        byte[] stream =
        [
            .. TestPackets.Motion(1), .. TestPackets.Line(2), .. TestPackets.Motion(3), .. TestPackets.Line(4, end: "||"), .. TestPackets.Calculation(5),
            .. TestPackets.Line(6, count: 946, lead: "", end: "\n"), .. TestPackets.Studio(7), .. TestPackets.Line(8, end: "||\r\n\0"), .. TestPackets.Motion(9),
        ];
        PacketLog log = Read(stream);
        Assert.Equal([1, 2, 3, 4, 5, 6, 7, 8, 9], log.Packets.Select(packet => (int)ValuesOf(packet.Bytes)[0]));
        Assert.Equal(0, log.Skipped);
    }

    // Digits, words and line ends in front of a packet: it is there with its last byte all the same.
    [Theory]
    [InlineData("\n0 Char00 1.0 2.0 ")]
    [InlineData("5")]
    [InlineData("0 ")]
    [InlineData("\n1 2 3 |")]
    [InlineData("\n0 \u00E6\u00CF")]
    [InlineData("garbage\n7")]
    public void What_looks_like_text_never_holds_a_packet_up(string noise)
    {
        byte[] bytes = Encoding.Latin1.GetBytes(noise);
        foreach (byte[] packet in (byte[][])[TestPackets.Motion(1), TestPackets.Calculation(1), TestPackets.Studio(1)])
        {
            PacketLog log = Read([.. bytes, .. packet]);
            Assert.Equal(packet, Assert.Single(log.Packets).Bytes);
            Assert.Equal(bytes.Length, log.Skipped);
        }
    }

    [Fact]
    public void Text_without_an_end_is_given_up_and_takes_bounded_memory()
    {
        var log = new PacketLog();
        var assembler = new PacketAssembler(new PacketScanner(), log);
        byte[] digits = Encoding.ASCII.GetBytes(string.Concat(Enumerable.Repeat("0 1 2 3 ", 1000)));
        int most = 0;
        for (int i = 0; i < 100; i++)
        {
            assembler.Push(digits, timestamp: 0);
            most = Math.Max(most, assembler.PendingBytes);
        }

        assembler.Push(Encoding.ASCII.GetBytes("\n"), timestamp: 0);
        assembler.Push(TestPackets.Line(3), timestamp: 0);
        Assert.InRange(most, 8_000, StreamScanner.LongestLine);
        Assert.Equal(3, ValuesOf(Assert.Single(log.Packets).Bytes)[0]);
        Assert.Equal((100 * digits.Length) + 1, log.Skipped);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(700)]
    [InlineData(100_000)]
    public void Reading_lines_allocates_nothing(int pieceSize)
    {
        byte[] stream = [.. TestPackets.Line(1), .. TestPackets.Line(2, count: 946, lead: "", end: "\0\n"), .. TestPackets.Line(3, count: 353)];
        var counts = new Counts();
        var assembler = new PacketAssembler(new PacketScanner(), counts);
        Allocations.AssertNone(() =>
        {
            for (int at = 0; at < stream.Length; at += pieceSize)
                assembler.Push(new ArraySegment<byte>(stream, at, Math.Min(pieceSize, stream.Length - at)), timestamp: 0);
        });
        Assert.Equal(300, counts.Packets);
    }

    private static string Line(int frame, int count, string end, string? lead = null, string separator = " ") =>
        Encoding.UTF8.GetString(TestPackets.Line(frame, count: count, lead: lead, separator: separator, end: end));

    private static PacketLog ReadWith(string word, string behind = "")
    {
        string[] words = [.. Enumerable.Range(0, 180).Select(index => index == 100 ? word : "0.5")];
        return Read($"0 Char00 {string.Join(' ', words)} ||\r\n{behind}");
    }

    private static PacketLog Read(string text) => Read(Encoding.UTF8.GetBytes(text));

    // Whole, and byte by byte: the same has to come out.
    private static PacketLog Read(byte[] bytes)
    {
        PacketLog whole = Push([bytes]);
        PacketLog dripping = Push(bytes.Select(value => (byte[])[value]));
        Assert.Equal(whole.Packets.Select(packet => packet.Bytes), dripping.Packets.Select(packet => packet.Bytes));
        Assert.Equal((whole.Skipped, whole.Text), (dripping.Skipped, dripping.Text));
        return whole;
    }

    private static PacketLog Push(IEnumerable<byte[]> pieces)
    {
        var log = new PacketLog();
        var assembler = new PacketAssembler(new PacketScanner(), log);
        foreach (byte[] piece in pieces)
            assembler.Push(piece, timestamp: 0);

        return log;
    }

    private static float[] ValuesOf(byte[] packet) => MemoryMarshal.Cast<byte, float>(packet.AsSpan(64)).ToArray();

    private sealed class Counts : IPacketReceiver
    {
        public int Packets { get; private set; }

        public void OnLinkOpened()
        {
        }

        public void OnPacket(in ReceivedPacket packet) => Packets++;

        public void OnText(ReadOnlySpan<byte> bytes)
        {
        }

        public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason)
        {
        }
    }
}
