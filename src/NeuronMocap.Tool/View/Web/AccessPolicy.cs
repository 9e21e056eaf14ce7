using System.Net;
using System.Net.Sockets;
using Microsoft.AspNetCore.Http;
using NeuronMocap.AspNetCore;

namespace NeuronMocap.Tool.View.Web;

/// <summary>Decides who may use the server.</summary>
/// <param name="token">The word that a browser must send; null for none.</param>
/// <param name="isRandom">Whether the next start of the program has another token.</param>
/// <param name="isPublic">Whether other computers can reach the server.</param>
/// <param name="origins">The origins under which a proxy shows the page, such as https://show.example.</param>
internal sealed class AccessPolicy(string? token, bool isRandom, bool isPublic, IReadOnlyList<string> origins)
{
    private const string Localhost = "localhost";
    private const string NoToken = "The address has no token, so the program does not know that you may see this.";
    private const string WrongToken = "The token is not that of the running program.";
    private const string NewToken = " Each start of the program makes a new one.";

    // The names of this computer. A name of somebody else leads here only by DNS rebinding.
    private readonly HashSet<string> _names = new((isPublic ? NamesOfThisComputer() : []).Concat(origins.Select(HostOf)), StringComparer.OrdinalIgnoreCase);

    /// <summary>Finds out why a request is refused.</summary>
    /// <returns>A status and a sentence; null if the request is allowed.</returns>
    public (int Status, string Reason)? FindRefusal(HttpRequest request)
    {
        if (!IsHostAllowed(request.Host))
            return (StatusCodes.Status421MisdirectedRequest, "The address of the page does not name this computer. Open the link that the program shows.");

        // Everybody may load the page itself. It holds nothing of the stream.
        if (PageFiles.Contain(request.Path))
            return null;
        if (!IsOriginAllowed(request))
            return (StatusCodes.Status403Forbidden, "Pages of other web sites may not use this server.");
        if (token is not null && !AccessToken.IsIn(request, token))
            return (StatusCodes.Status401Unauthorized, DescribeToken(request));

        return null;
    }

    /// <summary>Whether a host is localhost or a loopback address.</summary>
    public static bool IsOfThisComputer(HostString host)
    {
        string name = NameOf(host);
        return IPAddress.TryParse(name, out IPAddress? address) ? IPAddress.IsLoopback(address) : name.Equals(Localhost, StringComparison.OrdinalIgnoreCase);
    }

    private string DescribeToken(HttpRequest request) => !AccessToken.IsGiven(request) ? NoToken : isRandom ? WrongToken + NewToken : WrongToken;

    // An address in digits is never the result of DNS rebinding.
    private bool IsHostAllowed(HostString host)
    {
        string name = NameOf(host);
        return IsOfThisComputer(host) || _names.Contains(name) || (isPublic && IPAddress.TryParse(name, out _));
    }

    private bool IsOriginAllowed(HttpRequest request)
    {
        string origin = request.Headers.Origin.ToString();
        if (origin.Length > 0)
            return IsSame(origin, request) || origins.Any(allowed => AllowedOrigin.IsSame(allowed, origin));

        // Browsers leave the origin out of plain requests, but say where they come from. Another port of this computer is the same site.
        return request.Headers["Sec-Fetch-Site"].ToString() is "" or "same-origin" or "none";
    }

    private static bool IsSame(string origin, HttpRequest request) => origin.Equals($"{request.Scheme}://{request.Host}", StringComparison.OrdinalIgnoreCase);

    private static string NameOf(HostString host) => host.Host.Trim('[', ']').TrimEnd('.');

    private static string HostOf(string origin) => new Uri(origin).IdnHost;

    private static string[] NamesOfThisComputer()
    {
        try
        {
            string name = Dns.GetHostName();
            string first = name.Split('.')[0];
            return [name, first, first + ".local", first + ".lan", first + ".home"];
        }
        catch (SocketException)
        {
            // A computer without a name is reached by its address.
            return [];
        }
    }
}
