using System.Diagnostics.CodeAnalysis;
using System.Net;

namespace NeuronMocap.Polyfills;

internal static class AddressPolyfills
{
    extension(IPAddress)
    {
        public static bool TryParse(ReadOnlySpan<char> text, [NotNullWhen(true)] out IPAddress? address) => IPAddress.TryParse(text.ToString(), out address);
    }
}
