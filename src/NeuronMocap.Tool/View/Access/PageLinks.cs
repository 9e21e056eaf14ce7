using System.Net;
using System.Net.NetworkInformation;
using System.Net.Sockets;

namespace NeuronMocap.Tool.View.Access;

/// <summary>The links to the page.</summary>
internal static class PageLinks
{
    /// <summary>The link for a browser on this computer.</summary>
    /// <param name="server">Where the server listens.</param>
    /// <param name="token">The word that browsers must send; null for none.</param>
    public static string OfThisComputer(IPEndPoint server, string? token) => IsAny(server.Address)
        ? Of(server.AddressFamily == AddressFamily.InterNetworkV6 ? IPAddress.IPv6Loopback : IPAddress.Loopback, server.Port, token)
        : Of(server.Address, server.Port, token);

    /// <summary>The links for other computers, the most likely one first. Empty if the server is only for this computer.</summary>
    public static IReadOnlyList<string> OfOthers(IPEndPoint server, string? token)
    {
        if (IPAddress.IsLoopback(server.Address))
            return [];

        return [.. (IsAny(server.Address) ? OwnAddresses(server.AddressFamily) : [server.Address]).Select(address => Of(address, server.Port, token))];
    }

    /// <summary>The link to the page behind a proxy.</summary>
    public static string OfProxy(string origin, string? token) => $"{origin.TrimEnd('/')}/{QueryOf(token)}";

    private static bool IsAny(IPAddress address) => address.Equals(IPAddress.Any) || address.Equals(IPAddress.IPv6Any);

    private static string Of(IPAddress address, int port, string? token) => $"http://{new IPEndPoint(address, port)}/{QueryOf(token)}";

    private static string QueryOf(string? token) => token is null ? string.Empty : $"?token={token}";

    // Networks with a gateway come first: phones and other computers are there. Virtual networks usually have none.
    private static IPAddress[] OwnAddresses(AddressFamily family)
    {
        try
        {
            return
            [
                .. NetworkInterface.GetAllNetworkInterfaces()
                    .Where(static network => network is { OperationalStatus: OperationalStatus.Up, NetworkInterfaceType: not NetworkInterfaceType.Loopback })
                    .Select(static network => network.GetIPProperties())
                    .OrderByDescending(static properties => properties.GatewayAddresses.Count)
                    .SelectMany(static properties => properties.UnicastAddresses)
                    .Select(static unicast => unicast.Address)
                    .Where(address => address.AddressFamily == family && !address.IsIPv6LinkLocal),
            ];
        }
        catch (NetworkInformationException)
        {
            return [];
        }
    }
}
