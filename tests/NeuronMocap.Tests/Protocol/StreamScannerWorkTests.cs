using System.Text;
using NeuronMocap.Protocol;
using NeuronMocap.Tests.Network;

namespace NeuronMocap.Tests.Protocol;

/// <summary>Each hostile byte is examined only a few times, whatever the bytes are. The examinations are counted, not timed.</summary>
public class StreamScannerWorkTests
{
    // Examinations of each byte: for its possible line, for a packet, and for the start of the next line.
    private const int MostLooks = 4;

    private const int Length = 64 * 1024;

    [Theory]
    [InlineData("1\u0001\n")]
    [InlineData("\n1\u0001")]
    [InlineData("1\u0001\n\n")]
    [InlineData("1 \u0001\r\n")]
    [InlineData("12 34 5\u0001\n ")]
    [InlineData("\u0001\n1")]
    [InlineData("\u0001\n")]
    [InlineData("\u0001\n \t")]
    [InlineData("\u0001")]
    [InlineData("\n")]
    [InlineData("1\n")]
    [InlineData("1||")]
    [InlineData("1|")]
    [InlineData("1 A 2||")]
    [InlineData("1 \u00CF\n")]
    [InlineData("\u00CF")]
    [InlineData("\u00FF\u00DD")]
    [InlineData("\u00FF\u00DD\n1\u0001")]
    [InlineData("1\u0001\n\u00CF\u00DC")]
    [InlineData("1 2 3 4 5 6 7 8 9 ")]
    [InlineData("0 A 1 2 3 4\u0001\n")]
    public void Repeated_bytes_are_scanned_a_few_times(string pattern)
    {
        byte[] bytes = Repeat(Encoding.Latin1.GetBytes(pattern), Length);
        Assert.InRange(Scan(bytes), 0, MostLooks * Length);
    }

    // A packet that is announced but never comes does not keep bytes from being skipped.
    [Fact]
    public void A_large_header_is_scanned_once()
    {
        byte[] header = TestPackets.Motion(1, layout: HeaderLayout.Old, count: 100_000)[..ProtocolConstants.HeaderSize];
        byte[] bytes = [.. header, .. Repeat("1\u0001\n"u8.ToArray(), 400_000), .. Repeat("1\u0001\n"u8.ToArray(), Length)];
        Assert.InRange(Scan(bytes), 0, MostLooks * (long)bytes.Length);
    }

    [Fact]
    public void Random_token_bytes_are_scanned_a_few_times()
    {
        byte[] letters = [(byte)'1', (byte)' ', (byte)'\n', (byte)'\r', (byte)'|', (byte)'A', 0, 1, 0xFF, 0xDD, 0xCF, 0xDC];
        var random = new Random(1);
        for (int round = 0; round < 200; round++)
        {
            byte[] few = [.. Enumerable.Range(0, 4).Select(_ => letters[random.Next(letters.Length)])];
            byte[] bytes = new byte[4096];
            for (int i = 0; i < bytes.Length; i++)
                bytes[i] = random.Next(20) == 0 ? letters[random.Next(letters.Length)] : few[random.Next(few.Length)];

            Assert.InRange(Scan(bytes), 0, MostLooks * bytes.Length);
        }
    }

    // A section known to hold no packet must not hide a later packet or line.
    [Fact]
    public void Packets_and_lines_after_hostile_text_are_found_at_every_split()
    {
        byte[] hostile = Repeat("1\u0001\n"u8.ToArray(), 40);
        byte[] packet = TestPackets.Motion(1, count: 3);
        byte[] line = Encoding.ASCII.GetBytes("0 A " + string.Join(' ', Enumerable.Range(0, 180)) + "||\n");
        byte[] stream = [.. hostile, .. packet, .. hostile, .. line, .. hostile, .. packet, 1, .. packet, .. hostile];
        for (int split = 0; split <= stream.Length; split++)
            Assert.Equal("packet line packet packet", Deliver(stream[..split], stream[split..]));

        Assert.Equal("packet line packet packet", Deliver([.. stream.Select(static value => new[] { value })]));
    }

    private static byte[] Repeat(byte[] pattern, int length) => [.. Enumerable.Range(0, length).Select(index => pattern[index % pattern.Length])];

    private static long Scan(byte[] bytes)
    {
        var scanner = new StreamScanner(new PacketScanner());
        ReadOnlySpan<byte> rest = bytes;
        while (!rest.IsEmpty && scanner.Scan(rest) is { Part: not StreamPart.NeedMoreData } scan)
            rest = rest[scan.Length..];

        return scanner.Examined;
    }

    private static string Deliver(params byte[][] pieces)
    {
        var found = new List<string>();
        var receiver = new Receiver(found);
        var assembler = new PacketAssembler(new PacketScanner(), receiver);
        foreach (byte[] piece in pieces)
            assembler.Push(piece, timestamp: 0);

        return string.Join(' ', found);
    }

    private sealed class Receiver(List<string> found) : IPacketReceiver
    {
        public void OnPacket(in ReceivedPacket packet) => found.Add(packet.IsText ? "line" : "packet");

        public void OnText(ReadOnlySpan<byte> bytes, PacketKind kind)
        {
        }

        public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason)
        {
        }
    }
}
