using System.Net;

namespace NeuronMocap.AspNetCore;

// The origins of pages: scheme, host and port, as browsers send them.
internal static class AllowedOrigin
{
    private const string Any = "*";

    // Of pages that have no site, such as files.
    private const string OfNoSite = "null";

    public static bool IsValid(string? origin) => origin is Any or OfNoSite
        || (Uri.TryCreate(origin, UriKind.Absolute, out Uri? address) && address.Host.Length > 0 && address.GetLeftPart(UriPartial.Authority).Length == origin.TrimEnd('/').Length);

    // The host of a page is not compared with that of the request: an attacker's name can lead to any address.
    public static bool Allows(IReadOnlyList<string> allowed, string origin) => IsOfThisComputer(origin) || allowed.Any(each => each is Any || IsSame(each, origin));

    private static bool IsSame(string one, string other) => Normalize(one).Equals(Normalize(other), StringComparison.OrdinalIgnoreCase);

    // A port that the scheme implies may be written or left out.
    private static string Normalize(string origin) =>
        Uri.TryCreate(origin, UriKind.Absolute, out Uri? address) ? $"{address.Scheme}://{address.Host}:{address.Port}" : origin;

    private static bool IsOfThisComputer(string origin) => Uri.TryCreate(origin, UriKind.Absolute, out Uri? address) && address.Scheme is "http" or "https"
        && (address.Host.Equals("localhost", StringComparison.OrdinalIgnoreCase)
            || (IPAddress.TryParse(address.Host.Trim('[', ']'), out IPAddress? host) && IPAddress.IsLoopback(host)));
}
