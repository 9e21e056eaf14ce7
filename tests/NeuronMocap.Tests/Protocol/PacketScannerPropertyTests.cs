using NeuronMocap.Protocol;
using NeuronMocap.Tests.Infrastructure;

namespace NeuronMocap.Tests.Protocol;

/// <summary>Random streams against <see cref="ReferenceScanner"/>; a failure names the seed that repeats it.</summary>
public sealed class PacketScannerPropertyTests
{
    private const int MaxValues = 50;

    private static readonly byte[] TokenBytes = [0xFF, 0xFF, 0xFF, 0xDD, 0xEE, 0x88, 0x99, 0xAA, 0xBB, 0x00, 0x01, 0x02];

    [Fact]
    public void Any_splitting_of_any_stream_gives_what_the_slow_reader_gives()
    {
        var scanner = new PacketScanner(MaxValues);
        int packets = 0;
        for (int seed = 0; seed < 1500; seed++)
        {
            var random = new Random(seed);
            byte[] stream = RandomStream(random);
            (List<FoundPacket> expected, long skipped, int pending) = ReferenceScanner.Read(stream, MaxValues);
            packets += expected.Count;

            IEnumerable<IEnumerable<ArraySegment<byte>>> deliveries =
            [
                .. Deliveries.Of(stream, Delivery.Whole),
                .. Deliveries.Of(stream, Delivery.ByteByByte),
                Deliveries.Random(stream, random),
                Deliveries.Random(stream, random),
            ];
            foreach (IEnumerable<ArraySegment<byte>> pieces in deliveries)
            {
                var scan = ScanAll.Of(pieces, scanner);
                Assert.Equal(
                    $"seed {seed}: {Describe(expected, skipped, pending)}",
                    $"seed {seed}: {Describe(scan.Packets, scan.Skipped, scan.Pending)}");
                Assert.All(scan.Packets.Zip(expected), pair => Assert.Equal(pair.Second.Bytes, pair.First.Bytes));
            }
        }

        Assert.True(packets > 3000, $"Only {packets} packets: the streams are too poor to prove anything.");
    }

    [Fact]
    public void The_number_of_headers_refused_does_not_depend_on_the_splitting()
    {
        var scanner = new PacketScanner(MaxValues);
        int refused = 0;
        for (int seed = 0; seed < 1000; seed++)
        {
            var random = new Random(seed);
            byte[] stream = RandomStream(random);
            var whole = ScanAll.Of(stream, scanner);
            var pieces = ScanAll.Of(Deliveries.Random(stream, random), scanner);
            refused += whole.UnknownVersions + whole.TooLarge;

            Assert.True(
                (whole.UnknownVersions, whole.TooLarge) == (pieces.UnknownVersions, pieces.TooLarge),
                $"Seed {seed}: {whole.UnknownVersions} and {whole.TooLarge}, in pieces {pieces.UnknownVersions} and {pieces.TooLarge}.");
        }

        Assert.True(refused > 400, $"Only {refused} refused headers: the streams are too poor to prove anything.");
    }

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

        var scan = ScanAll.Of(Deliveries.Random(garbage, random), new PacketScanner(1_000_000));

        Assert.Equal(garbage.Length, scan.Packets.Sum(packet => (long)packet.Bytes.Length) + scan.Skipped + scan.Pending);
    }

    private static byte[] RandomStream(Random random)
    {
        List<byte> stream = [];
        for (int parts = random.Next(1, 12); parts > 0; parts--)
            stream.AddRange(RandomPart(random));

        return [.. stream];
    }

    private static byte[] RandomPart(Random random)
    {
        byte[] packet = RandomPacket(random);
        switch (random.Next(10))
        {
            case 0:
                return [.. Enumerable.Range(0, random.Next(1, 200)).Select(_ => TokenBytes[random.Next(TokenBytes.Length)])];
            case 1:
                byte[] noise = new byte[random.Next(1, 200)];
                random.NextBytes(noise);
                return noise;
            case 2: // cut off at the end
                return packet[..random.Next(packet.Length)];
            case 3: // cut off at the start
                return packet[random.Next(packet.Length)..];
            case 4: // one byte of the header changed
                packet[random.Next(64)] = TokenBytes[random.Next(TokenBytes.Length)];
                return packet;
            case 5: // another version
                packet[4 + random.Next(2)] = (byte)random.Next(3);
                return packet;
            case 6: // a huge count, where the layout counts in 32 bits
                packet[9] = 0xFF;
                return packet;
            default:
                return packet;
        }
    }

    private static byte[] RandomPacket(Random random)
    {
        float[] values = [.. Enumerable.Range(0, random.Next(MaxValues + 4)).Select(_ => random.NextSingle())];
        return random.Next(6) switch
        {
            0 or 1 => GoldenPackets.NewMotion(values),
            2 => GoldenPackets.OldMotion(values),
            3 => GoldenPackets.CalculationData(values),
            4 => GoldenPackets.OldCommand(command: 4, (uint)values.Length, values.Length),
            _ => GoldenPackets.OldCommand(command: 0, (uint)values.Length % 3, 64 * (values.Length % 3)),
        };
    }

    private static string Describe(List<FoundPacket> packets, long skipped, int pending) =>
        $"[{string.Join(' ', packets.Select(packet => $"{packet.Kind}:{packet.Bytes.Length}"))}] skipped {skipped} pending {pending}";
}
