using System.Text;

namespace NeuronMocap.Fuzz.Grammar;

/// <summary>Numbers as text: the limits of formats and types, and texts that are not numbers.</summary>
internal static class NumberWords
{
    public static IReadOnlyList<byte[]> Extremes { get; } =
    [
        .. ((string[])[
            "0", "-0", "1", "-1", "0.0000001", "1e-46", "1e-38", "1e6", "1e12", "-1e12", "1e30", "3.4028235e38", "-3.4028235e38", "1e39", "nan", "-nan(ind)", "inf",
            "-inf", "2147483647", "2147483648", "-2147483648", "4294967296", "9223372036854775807", "9223372036854775808", "1e308", "1e309", "180", "-180", "90", "360.0",
            "1e7", "999999999999999999999999", "16777217", "0.", ".", "", "x",
        ]).Select(Encoding.ASCII.GetBytes),
    ];
}
