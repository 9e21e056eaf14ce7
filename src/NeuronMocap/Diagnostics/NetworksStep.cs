using System.Net;

namespace NeuronMocap.Diagnostics;

// Lists the networks of this computer, and says which one is used. A wrong network is the usual fault of a computer with several.
internal static class NetworksStep
{
    private const int MaxListed = 8;

    // used: the address of this computer that the connection uses; null if it uses none, or all.
    // remote: the server; null if it is not known.
    public static void Add(StepLog log, IReadOnlyList<OwnNetwork> all, IPAddress? used, IPAddress? remote)
    {
        OwnNetwork[] networks = [.. all.Where(static network => !network.IsLoopback && (network.IsUp || network.Address is null))];
        if (networks.Length == 0)
            return;

        string list = string.Join(", ", networks.OrderByDescending(network => Uses(network, used)).Take(MaxListed).Select(network => Describe(network, used)));
        if (networks.Length > MaxListed)
            list += FormattableString.Invariant($" and {networks.Length - MaxListed} more");

        if (FindDoubt(networks, used, remote) is { } doubt)
            log.Warning("networks", $"{list}: {doubt}");
        else
            log.Ok("networks", list);
    }

    private static string? FindDoubt(OwnNetwork[] networks, IPAddress? used, IPAddress? remote)
    {
        if (networks.All(static network => !network.IsUp || network.Address is null))
            return "no network of this computer is up";

        OwnNetwork own = networks.FirstOrDefault(network => Uses(network, used));
        if (own.Address is not null && remote is not null && !own.Contains(remote))
        {
            OwnNetwork better = networks.FirstOrDefault(network => network.Contains(remote));
            if (better.Address is not null)
                return $"the server {remote} is in the network of {better.Name}, but the connection uses {own.Name}. Set LocalAddress to {better.Address}";
        }

        return own.IsVpn ? $"the connection uses a VPN. If the server is not behind it, set LocalAddress to an address of the server's network" : null;
    }

    private static bool Uses(OwnNetwork network, IPAddress? used) => used is not null && used.Equals(network.Address);

    private static string Describe(OwnNetwork network, IPAddress? used)
    {
        string state = Uses(network, used) ? " (used)" : network.IsVpn ? " (VPN)" : string.Empty;
        return (network.IsUp, network.Address) switch
        {
            (false, _) => $"{network.Name} is down",
            (_, null) => $"{network.Name} has no address",
            _ => FormattableString.Invariant($"{network.Name} {network.Address}/{network.PrefixLength}{state}"),
        };
    }
}
