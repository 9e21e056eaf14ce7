using System.Globalization;
using System.Runtime.CompilerServices;

namespace NeuronMocap.Tests.Infrastructure;

// All tests run as on a computer whose numbers have a comma and another minus sign, such as Swedish. What is written to files, sent and said must not
// depend on it.
internal static class ForeignCulture
{
    [ModuleInitializer]
    internal static void Use()
    {
        var culture = (CultureInfo)CultureInfo.InvariantCulture.Clone();
        (culture.NumberFormat.NumberDecimalSeparator, culture.NumberFormat.NumberGroupSeparator) = (",", " ");
        culture.NumberFormat.NegativeSign = "\u2212";
        (culture.DateTimeFormat.DateSeparator, culture.DateTimeFormat.TimeSeparator) = (".", ".");
        CultureInfo.CurrentCulture = culture;
        CultureInfo.DefaultThreadCurrentCulture = culture;
    }
}
