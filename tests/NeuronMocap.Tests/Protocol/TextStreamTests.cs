using System.Text;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;
using static NeuronMocap.Tests.Protocol.TextReading;

namespace NeuronMocap.Tests.Protocol;

/// <summary>The start and end of lines of text in a stream. Each case is read whole and byte by byte.</summary>
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

    [Fact]
    public void Zero_bytes_are_ignored_everywhere()
    {
        string line = Line(6, 180, " ||\r\n");
        PacketLog log = Read(line[..9] + "\0" + line[9..100] + "\0\0" + line[100..] + "\0\0\0" + line);
        Assert.Equal(2, log.Packets.Count);
        Assert.Equal(log.Packets[1].Bytes, log.Packets[0].Bytes);
        Assert.Equal(0, log.Skipped);
    }

    // A stream joined in the middle of a line.
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

    // In a line of 360 values, the last 356 words could be the number, the name and the values of a line of 354.
    [Fact]
    public void A_late_start_gives_no_frame_from_a_partial_line()
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
    public void A_late_start_reads_from_the_first_named_line()
    {
        var log = new PacketLog();
        var assembler = new PacketAssembler(new PacketScanner(), log);
        assembler.JoinLate();
        assembler.Push(Encoding.UTF8.GetBytes(Line(1, 354, " ||\r\n")), timestamp: 0);
        Assert.Single(log.Packets);
    }

    [Fact]
    public void Packets_and_lines_may_alternate()
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

    // Digits, words and line ends before a packet do not delay it: it is complete with its last byte.
    [Theory]
    [InlineData("\n0 Char00 1.0 2.0 ")]
    [InlineData("5")]
    [InlineData("0 ")]
    [InlineData("\n1 2 3 |")]
    [InlineData("\n0 \u00E6\u00CF")]
    [InlineData("garbage\n7")]
    public void Text_never_delays_a_packet(string noise)
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
    public void Endless_text_takes_bounded_memory()
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

        // More if a round was repeated.
        Assert.InRange(counts.Packets, 300, int.MaxValue);
    }

    private sealed class Counts : IPacketReceiver
    {
        public int Packets { get; private set; }

        public void OnPacket(in ReceivedPacket packet) => Packets++;

        public void OnText(ReadOnlySpan<byte> bytes, PacketKind kind)
        {
        }

        public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason)
        {
        }
    }
}
