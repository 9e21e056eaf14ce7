using System.Globalization;
using System.Text;

namespace NeuronMocap.Tests.Infrastructure;

/// <summary>Specifies how the numbers of a line are written.</summary>
internal enum TextNumbers
{
    TwoDecimals,

    /// <summary>All allowed ways, in turn.</summary>
    EveryWay,

    /// <summary>One word in the middle is not a number.</summary>
    OneWrong,

    /// <summary>Zero bytes within and between the words.</summary>
    WithZeros,
}

/// <summary>A line of the text stream.</summary>
internal sealed record TextPart(int Count, string Lead, TextNumbers Numbers, string Separator, string End) : WirePart
{
    private static readonly string[] Ways =
    [
        "0.00", "-1.50", "+2", ".5", "-5.", "1e3", "-2.5E-3", "0,25", "-180,0", "nan", "-nan(ind)", "1.#QNAN", "-1.#IND", "inf", "-1.#INF00",
        "16777217", "0.1000000014901161193847656250", "1e-46", "3.5e38", "7.0064923216240862e-46",
    ];

    public override byte[] ToBytes()
    {
        IEnumerable<string> words = Enumerable.Range(0, Count).Select(WordAt);
        return Encoding.UTF8.GetBytes($"{Lead}{string.Join(Separator, words)}{End}");
    }

    public override IEnumerable<WirePart> Simpler() =>
    [
        .. Numbers == TextNumbers.TwoDecimals ? (IEnumerable<WirePart>)[] : [this with { Numbers = TextNumbers.TwoDecimals }],
        .. Count < 10 ? (IEnumerable<WirePart>)[] : [this with { Count = 3 }],
        .. Lead.Length < 5 ? (IEnumerable<WirePart>)[] : [this with { Lead = "0 A " }],
    ];

    private string WordAt(int index) => Numbers switch
    {
        TextNumbers.EveryWay => Ways[index % Ways.Length],
        TextNumbers.OneWrong when index == Count / 2 => "1x",
        TextNumbers.WithZeros when index % 7 == 3 => "1\0.5\0",
        _ => (index * 0.25).ToString("0.00", CultureInfo.InvariantCulture),
    };
}
