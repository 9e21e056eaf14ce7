using System.Net;
using System.Net.NetworkInformation;

namespace NeuronMocap.Diagnostics;

// One address of this computer. A network that is down, or has no address, has no Address.
internal readonly record struct OwnNetwork(string Name, IPAddress? Address, int PrefixLength, bool IsUp = true, bool IsVpn = false)
{
    private static readonly string[] VpnNames = ["tun", "tap", "wg", "utun", "ppp", "ipsec", "zt", "tailscale", "nordlynx"];
    private static readonly string[] VpnDescriptions = ["vpn", "wireguard", "tap-windows", "tailscale", "zerotier", "hamachi"];

    public bool IsLoopback => Address is not null && IPAddress.IsLoopback(Address);

    // Whether the network has other addresses. A tunnel may have none, and the length of a prefix may be unknown: neither tells who is behind a router.
    public bool HasNeighbours => Address is not null && PrefixLength > 0 && PrefixLength < 8 * Address.GetAddressBytes().Length;

    public bool Contains(IPAddress other)
    {
        if (Address is null)
            return false;

        byte[] left = other.GetAddressBytes();
        byte[] right = Address.GetAddressBytes();
        if (left.Length != right.Length || PrefixLength == 0)
            return false;

        for (int bit = 0; bit < PrefixLength; bit++)
        {
            int mask = 0x80 >> (bit % 8);
            if (((left[bit / 8] ^ right[bit / 8]) & mask) != 0)
                return false;
        }

        return true;
    }

    // Empty on runtimes that lack this. The result is only shown, never needed.
    public static IReadOnlyList<OwnNetwork> FindAll()
    {
        try
        {
            return [.. NetworkInterface.GetAllNetworkInterfaces().SelectMany(Read)];
        }
        catch (Exception exception) when (exception is NetworkInformationException or PlatformNotSupportedException or NotImplementedException)
        {
            // Not every runtime and system lists its networks; Unity's players do not. The diagnosis then continues and says less about the route.
            return [];
        }
    }

    public static bool IsVpnNamed(string name, string description) =>
        VpnNames.Any(word => name.StartsWith(word, StringComparison.OrdinalIgnoreCase))
        || VpnDescriptions.Any(word => description.Contains(word, StringComparison.OrdinalIgnoreCase));

    private static IEnumerable<OwnNetwork> Read(NetworkInterface network)
    {
        // Linux does not know the state of some networks that work, such as those of tunnels.
        bool isUp = network.OperationalStatus is OperationalStatus.Up or OperationalStatus.Unknown;
        bool isVpn = network.NetworkInterfaceType == NetworkInterfaceType.Ppp || IsVpnNamed(network.Name, network.Description);
        OwnNetwork[] addresses = isUp
            ? [.. network.GetIPProperties().UnicastAddresses.Where(static own => !own.Address.IsIPv6LinkLocal)
                .Select(own => new OwnNetwork(network.Name, own.Address, ReadPrefixLength(own), isUp, isVpn))]
            : [];
        return addresses.Length > 0 ? addresses : [new OwnNetwork(network.Name, Address: null, PrefixLength: 0, isUp, isVpn)];
    }

    // Mono knows only the mask, which is for IPv4. 0 for an unknown length.
    private static int ReadPrefixLength(UnicastIPAddressInformation own)
    {
        try
        {
            return own.PrefixLength;
        }
        catch (NotImplementedException)
        {
            return own.IPv4Mask is { } mask ? mask.GetAddressBytes().Sum(static part => CountBits(part)) : 0;
        }
    }

    private static int CountBits(int part)
    {
        int count = 0;
        for (; part != 0; part &= part - 1)
            count++;

        return count;
    }
}
