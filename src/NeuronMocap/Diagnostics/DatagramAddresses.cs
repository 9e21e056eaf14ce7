using System.Net;
using System.Net.Sockets;

namespace NeuronMocap.Diagnostics;

// The addresses of this computer that a server can send datagrams to, in words.
internal sealed class DatagramAddresses
{
    private readonly IPAddress? _bound;
    private readonly IReadOnlyList<IPAddress> _reachable;

    // bound: the only address that receives; null for all IPv4 addresses. reachable: the addresses that other computers can send to.
    public DatagramAddresses(IPAddress? bound, IReadOnlyList<IPAddress> reachable)
    {
        _bound = IPAddress.Any.Equals(bound) || IPAddress.IPv6Any.Equals(bound) ? null : bound;
        _reachable = reachable;
    }

    public string Route => _bound is { } bound
        ? IPAddress.IsLoopback(bound) ? $"only programs on this computer can send here, to {bound}" : $"other computers and programs on this one send to {bound}"
        : _reachable.Count > 0
            ? $"other computers send to {string.Join(" or ", _reachable)}, programs on this one to 127.0.0.1"
            : "this computer has no network: only programs on it can send here, to 127.0.0.1";

    // The destination for another computer, or for this one if no other computer can send here.
    public string FromNetwork(int port) => At(_bound ?? (_reachable.Count > 0 ? _reachable[0] : IPAddress.Loopback), port);

    public string Advice(int port)
    {
        string own = $"A server on this computer sends to {At(_bound ?? IPAddress.Loopback, port)}.";
        if (_bound is null)
            return own;
        if (IPAddress.IsLoopback(_bound))
            return $"{own} For a server on another computer, choose another LocalAddress, or none.";

        return DropsBroadcasts && IsAddressOfNetwork(_bound)
            ? $"{own} If the server sends to a broadcast address, leave out LocalAddress: with it, this system delivers no broadcasts."
            : own;
    }

    // On Linux, a local address can also be the broadcast address of a network. Not every runtime lists the addresses.
    private bool IsAddressOfNetwork(IPAddress address) =>
        address.AddressFamily == AddressFamily.InterNetwork && (_reachable.Count == 0 || _reachable.Contains(address));

    // Linux drops those that were sent to another address than the socket's, and probably macOS. Windows delivers them.
    private static bool DropsBroadcasts => !OperatingSystem.IsWindows();

    private static string At(IPAddress address, int port) => new IPEndPoint(address, port).ToString();
}
