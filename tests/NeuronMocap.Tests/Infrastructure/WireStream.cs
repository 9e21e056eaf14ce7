using FsCheck;
using FsCheck.Fluent;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>A generated stream, and the sizes of the pieces in which it arrives, repeated until the end. A size may be zero.</summary>
internal sealed record WireStream(WirePart[] Parts, int[] PieceSizes)
{
    /// <summary>The limit set for the scanner under test. It is low, so that tests of the limit are cheap.</summary>
    public const int MaxValues = 190;

    // Announced counts at every limit: zero, around the limit, where times four wraps around 32 bits, where a signed reading is negative.
    private static readonly uint[] CountEdges =
    [
        0, 1, MaxValues - 1, MaxValues, MaxValues + 1, 0xFFFF, 0x1_0000, 0x0400_0001, 0x3FFF_FFFF, 0x4000_0000, 0x4000_0001,
        0x7FFF_FFFF, 0x8000_0000, 0xFFFF_FFFF,
    ];

    private static readonly uint[] CommandEdges = [1_562, 1_563, 99_999, 100_000, 100_001, 0x0400_0001, 0x8000_0000, 0xFFFF_FFFF];

    private static readonly byte[] TokenBytes = [0xFF, 0xDD, 0xEE, 0x88, 0x99, 0xAA, 0xBB, 0xCF, 0xDC, 0xEC, 0x00, 0x01, 0x02, 0x0A, 0x20, 0x30, 0x7C];

    private static readonly Gen<WireShape> AnyShape = Gen.Elements(Enum.GetValues<WireShape>());

    private static readonly Gen<WireShape> DataShape = Gen.Elements(WireShape.NewMotion, WireShape.OldMotion, WireShape.Calculation, WireShape.StudioCalculation);

    private static readonly Gen<Filling> AnyFilling = Gen.Elements(Enum.GetValues<Filling>());

    private static readonly Gen<PacketKind> AnyKind = Gen.Elements(PacketKind.Motion, PacketKind.Calculation, PacketKind.Command, PacketKind.StudioCalculation);

    private static readonly Gen<int> AnyCount = Gen.Frequency(
        (6, Gen.Choose(0, 6)),
        (1, Gen.Choose(0, MaxValues)),
        (2, Gen.Elements(0, 1, MaxValues - 1, MaxValues, MaxValues + 1)));

    private static readonly Gen<int> AnyPieceSize = Gen.Frequency(
        (1, Gen.Constant(0)),
        (3, Gen.Choose(1, 3)),
        (2, Gen.Choose(60, 66)),
        (3, Gen.Choose(1, 80)),
        (1, Gen.Choose(80, 2_000)));

    /// <summary>Packets of every kind, with the payload that they announce.</summary>
    public static Gen<WirePart> WholePackets { get; } =
        from shape in AnyShape
        from count in AnyCount
        from filling in AnyFilling
        from avatar in Gen.Choose(0, 3)
        select (WirePart)new Packet(shape, count, filling, (uint)avatar);

    /// <summary>Lines of text: frames, and near misses.</summary>
    public static Gen<WirePart> Lines { get; } =
        from count in Gen.Frequency((6, Gen.Elements(180, 186)), (1, Gen.Elements(338, 354, 178, 181)), (2, Gen.Choose(0, 5)))
        from lead in Gen.Elements("0 Char00 ", "7\t演员一 ", "0 演员一的一个很长很长的名字 ", "1 12.5 ", "2 7up ", "", "4294967296 A ", "-1 A ", "A 0 ", " 0  B  ", "0\0 C ", "0 Anna 演员 ", "1 A\0 |B\tC ", "0 Char 02 ", "3 7 up ")
        from numbers in Gen.Frequency((3, Gen.Constant(TextNumbers.TwoDecimals)), (1, Gen.Elements(Enum.GetValues<TextNumbers>())))
        from separator in Gen.Frequency((5, Gen.Constant(" ")), (1, Gen.Elements("\t", "  ", "\r")))
        from end in Gen.Elements(" ||\r\n", "||\r\n", "\n", "\r\n", "||", " ||\0\0", "|\r\n", " ", "\r", "||\0\r\n\0")
        select (WirePart)new TextPart(count, lead, numbers, separator, end);

    /// <summary>Everything that a stream can contain.</summary>
    public static Gen<WirePart> AnyPart { get; } = Gen.Frequency(
        (10, WholePackets),
        (6, Lines),
        (2, from line in Lines
            from skipped in Gen.Frequency((1, Gen.Constant(0)), (1, Gen.Choose(0, 900)))
            from length in Gen.Choose(0, 1_200)
            select (WirePart)new Stretch(line, skipped, length)),
        (2, from line in Lines
            from at in Gen.Choose(0, 400)
            from value in Gen.Elements(TokenBytes)
            select (WirePart)new Damaged(line, at, value)),
        (2, from shape in DataShape
            from count in Gen.Elements(CountEdges)
            from payload in Gen.Choose(0, 100)
            from filling in AnyFilling
            select (WirePart)new Promise(shape, count, payload, filling)),
        (1, from shape in Gen.Elements(WireShape.CommandWithBoneSizes, WireShape.CommandWithText)
            from count in Gen.Elements(CommandEdges)
            from payload in Gen.Frequency((20, Gen.Choose(0, 100)), (1, Gen.Constant(100_000)))
            select (WirePart)new Promise(shape, count, payload, Filling.Numbers)),
        (2, from parts in Gen.Four(Gen.Elements<byte>(0, 1, 1, 2, 0xFF))
            from count in Gen.Choose(0, 4)
            select (WirePart)new OfVersion(parts.Item1, parts.Item2, parts.Item3, parts.Item4, count)),
        (3, from first in AnyKind
            from second in AnyKind
            from distance in Gen.Frequency((1, Gen.Choose(0, 70)), (1, Gen.Choose(61, 63)))
            from behind in Gen.Choose(0, 40)
            select (WirePart)new TokenPair(first, second, distance, behind)),
        (3, from whole in WholePackets
            from skipped in Gen.Frequency((1, Gen.Constant(0)), (1, Gen.Choose(0, 80)))
            from length in Gen.Choose(0, 200)
            select (WirePart)new Stretch(whole, skipped, length)),
        (2, from whole in WholePackets
            from at in Gen.Choose(0, 67)
            from value in Gen.Elements(TokenBytes)
            select (WirePart)new Damaged(whole, at, value)),
        (3, from filling in AnyFilling
            from length in Gen.Choose(1, 150)
            select (WirePart)new Noise(filling, length)));

    /// <summary>Streams of up to a dozen parts.</summary>
    public static Gen<WireStream> Any { get; } =
        from count in Gen.Choose(0, 12)
        from parts in AnyPart.ArrayOf(count)
        from pieces in Gen.Choose(1, 6)
        from sizes in AnyPieceSize.ArrayOf(pieces)
        select new WireStream(parts, sizes);

    /// <summary>Streams that consist of whole packets within the limit.</summary>
    public static Gen<WireStream> OfWholePackets { get; } =
        from parts in WholePackets.Where(part => part is Packet packet && packet.IsAllowed()).ArrayOf()
        from pieces in Gen.Choose(1, 6)
        from sizes in AnyPieceSize.ArrayOf(pieces)
        select new WireStream(parts, sizes);

    public byte[] ToBytes() => [.. Parts.SelectMany(part => part.ToBytes())];

    public IEnumerable<WireStream> Simpler() =>
    [
        .. Properties.SimplerLists(Parts, part => part.Simpler()).Select(parts => this with { Parts = parts }),
        .. Properties.SimplerLists(PieceSizes, Properties.SimplerNumbers).Select(sizes => this with { PieceSizes = sizes }),
    ];

    /// <summary>Divides bytes into this stream's pieces.</summary>
    public IEnumerable<ArraySegment<byte>> Cut(byte[] bytes)
    {
        int start = 0;
        for (int i = 0; PieceSizes.Sum() > 0 && start < bytes.Length; i++)
        {
            int size = Math.Min(PieceSizes[i % PieceSizes.Length], bytes.Length - start);
            yield return new ArraySegment<byte>(bytes, start, size);
            start += size;
        }

        yield return new ArraySegment<byte>(bytes, start, bytes.Length - start);
    }

    public override string ToString() =>
        $"{string.Join(Environment.NewLine, Parts.Select(part => part.ToString()))}{Environment.NewLine}in pieces of {string.Join(", ", PieceSizes)}";
}
