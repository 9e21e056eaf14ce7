using System.Net;
using System.Net.Sockets;

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

        List<string> list = [.. networks.Where(HasAddress)
            .OrderByDescending(network => Uses(network, used))
            .ThenBy(static network => network.Address!.AddressFamily == AddressFamily.InterNetwork ? 0 : 1)
            .Select(network => Describe(network, used))];
        if (list.Count > MaxListed)
        {
            int more = list.Count - MaxListed;
            list.RemoveRange(MaxListed, more);
            list[^1] += FormattableString.Invariant($" and {more} more");
        }

        AddUnusable(list, networks.Where(static network => !network.IsUp), "is down", "are down");
        AddUnusable(list, networks.Where(static network => network.IsUp && network.Address is null), "has no address", "have no address");
        string detail = string.Join(", ", list);
        if (FindDoubt(networks, used, remote) is { } doubt)
            log.Warning("networks", $"{detail}: {doubt}");
        else
            log.Ok("networks", detail);
    }

    private static string? FindDoubt(OwnNetwork[] networks, IPAddress? used, IPAddress? remote)
    {
        if (!networks.Any(HasAddress))
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

    private static bool HasAddress(OwnNetwork network) => network.IsUp && network.Address is not null;

    private static string Describe(OwnNetwork network, IPAddress? used)
    {
        string state = Uses(network, used) ? " (used)" : network.IsVpn ? " (VPN)" : string.Empty;
        return FormattableString.Invariant($"{network.Name} {network.Address}/{network.PrefixLength}{state}");
    }

    // Networks that cannot be used are counted: a computer with containers has many, and their names would hide the others.
    private static void AddUnusable(List<string> list, IEnumerable<OwnNetwork> networks, string one, string several)
    {
        string[] names = [.. networks.Select(static network => network.Name)];
        if (names.Length > 0)
            list.Add(names.Length == 1 ? $"{names[0]} {one}" : FormattableString.Invariant($"{names.Length} {several}"));
    }
}
