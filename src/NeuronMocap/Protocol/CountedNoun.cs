using System.Globalization;

namespace NeuronMocap.Protocol;

// A number and what it counts, for messages.
internal static class CountedNoun
{
    // "1 frame", "2000 frames".
    public static string Of(long count, string noun) => string.Format(CultureInfo.InvariantCulture, "{0} {1}", count, count == 1 ? noun : noun + "s");

    // The word alone, without an allocation.
    public static string Word(double count, string one, string many) => count == 1 ? one : many;
}
