using System.Diagnostics.CodeAnalysis;
using System.Net;

namespace NeuronMocap.AspNetCore;

// The origins of pages: scheme, host and port, as browsers send them.
internal static class AllowedOrigin
{
    private const string Any = "*";

    // Of pages that have no site, such as files.
    private const string OfNoSite = "null";

    public static bool IsValid(string? origin) => origin is Any or OfNoSite
        || (TryParse(origin, out Uri? address) && EndsWithHost(origin!.TrimEnd('/'), address));

    // The host of a page is not compared with that of the request: an attacker's name can lead to any address.
    public static bool Allows(IReadOnlyList<string> allowed, string origin) => IsOfThisComputer(origin) || allowed.Any(each => each is Any || IsSame(each, origin));

    public static bool IsSame(string one, string other) => Normalize(one).Equals(Normalize(other), StringComparison.OrdinalIgnoreCase);

    // A port that the scheme implies may be written or left out. Browsers send other alphabets in their ASCII form.
    private static string Normalize(string origin) => TryParse(origin, out Uri? address) ? $"{address.Scheme}://{address.IdnHost}:{address.Port}" : origin;

    // Whether nothing follows the host and the port. The left part lacks a port that the scheme implies.
    private static bool EndsWithHost(string origin, Uri address)
    {
        string port = FormattableString.Invariant($":{address.Port}");
        int rest = origin.Length - address.GetLeftPart(UriPartial.Authority).Length;
        return rest == 0 || (address.IsDefaultPort && rest == port.Length && origin.EndsWith(port, StringComparison.Ordinal));
    }

    private static bool IsOfThisComputer(string origin) => TryParse(origin, out Uri? address) && address.Scheme is "http" or "https"
        && (address.Host.Equals("localhost", StringComparison.OrdinalIgnoreCase)
            || (IPAddress.TryParse(address.Host.Trim('[', ']'), out IPAddress? host) && IPAddress.IsLoopback(host)));

    private static bool TryParse(string? origin, [NotNullWhen(true)] out Uri? address) =>
        Uri.TryCreate(origin, UriKind.Absolute, out address) && address is { Host.Length: > 0, UserInfo.Length: 0 };
}
