using System.Diagnostics;

namespace NeuronMocap.Transport;

// Numbers the servers that send datagrams. A server has an address, one port for motion and one for calculation data; the two are often the same.
// A new port of a known address can mean three things, and the right one shows in time:
// - The same server restarted. It never sends from its old port again, so the old port stays silent. The new port continues under the server's number.
// - Another server runs on the same computer. Both send, and the new server gets its own number.
// - A server sends the other kind of data. The port joins this server at once.
// If a sender cannot be identified yet, the caller keeps its datagrams and asks again later. Not thread-safe.
internal sealed class UdpServers
{
    // A live server can be silent for this many times its longest recent pause, within bounds. Networks and busy computers delay datagrams by up to a
    // tenth of a second. No datagram waits longer than the upper bound.
    private const int Pauses = 4;
    private static readonly long ShortestSilence = Stopwatch.Frequency / 4;
    private static readonly long LongestSilence = Stopwatch.Frequency;

    // A slow handler, or a pause of the computer, makes a live server look silent. Its datagrams wait in the socket meanwhile. A new sender is therefore
    // also heard for this time before it takes the place of a silent one.
    private static readonly long Confirmation = Stopwatch.Frequency / 20;

    private readonly List<UdpServer> _servers = [];
    private int _nextServer;
    private int _nextNumber;
    private long _turn;

    public long NextTurn() => ++_turn;

    public int NextNumber() => _nextNumber++;

    public bool Knows(HostKey host) => _servers.Exists(server => server.Host == host);

    // Returns false if the sender cannot be identified yet. With isLast it always decides, because no more datagrams can wait. replaced: the earlier
    // sender of this number.
    public bool TryPlace(UdpSender sender, bool isCalculation, long clock, bool isLast, out UdpSender? replaced)
    {
        replaced = null;
        bool isOpen = false;
        sender.Due = long.MaxValue;
        (UdpServer? Server, int Rank) best = default;
        foreach (UdpServer server in _servers)
        {
            if (server.Host != sender.Host)
                continue;

            UdpSender? holder = server[isCalculation];
            if (holder is null || IsGone(holder, sender, clock, isLast))
            {
                best = Better(best, server, RankOf(server, holder, sender));
            }
            else if (holder.Turn < sender.Began)
            {
                isOpen = true;
                sender.Due = Math.Min(sender.Due, Math.Max(holder.Heard + SilenceOf(holder, isLast: false), sender.FirstHeard + Confirmation));
            }
        }

        if (best.Server is null && isOpen && !isLast)
            return false;

        replaced = best.Server?[isCalculation];
        Place(sender, best.Server ?? Add(sender.Host), isCalculation, replaced);
        return true;
    }

    // Called when a sender sends another kind of data than before. Returns true if its frames now belong to a different server than was assumed, or if
    // they continue a sender that is gone.
    public bool Learn(UdpSender sender, bool isCalculation, long clock, out UdpSender? replaced)
    {
        replaced = null;
        UdpServer server = sender.Server!;
        if (server[isCalculation] is not { } holder || holder == sender)
        {
            server[isCalculation] = sender;
            return false;
        }

        if (IsGone(holder, sender, clock, isLast: false))
        {
            replaced = holder;
            Place(sender, server, isCalculation, holder);
            return true;
        }

        Remove(sender);
        UdpServer own = Add(sender.Host);
        (own[isCalculation: false], own[isCalculation: true], sender.Server) = (sender, sender, own);
        return true;
    }

    public void Remove(UdpSender sender)
    {
        if (sender.Server is not { } server)
            return;

        server.Remove(sender);
        if (server.IsEmpty)
            _servers.Remove(server);
    }

    private static (UdpServer? Server, int Rank) Better((UdpServer? Server, int Rank) best, UdpServer server, int rank) =>
        best.Server is null || rank > best.Rank ? (server, rank) : best;

    // Of several servers on a computer, prefers the one with the same avatar. After that, prefers one whose sender of this kind is gone over one that
    // never had one.
    private static int RankOf(UdpServer server, UdpSender? holder, UdpSender sender) =>
        (server.Any!.Identity.IsOfSameAvatar(sender.Identity) ? 2 : 0) + (holder is null ? 0 : 1);

    // A holder that sent after the other sender began is alive beside it. At the end, several datagrams of the other sender without one of the holder show
    // that the holder is gone.
    private static bool IsGone(UdpSender holder, UdpSender sender, long clock, bool isLast) => holder.Turn < sender.Began
        && ((clock - holder.Heard > SilenceOf(holder, isLast) && (isLast || clock - sender.FirstHeard > Confirmation))
            || (isLast && sender.Held.Count > Pauses));

    private static long SilenceOf(UdpSender sender, bool isLast) =>
        Math.Min(Math.Max(Pauses * sender.LongestPause, isLast ? 0 : ShortestSilence), LongestSilence);

    // The replaced sender is gone and sends nothing more, of either kind.
    private static void Place(UdpSender sender, UdpServer server, bool isCalculation, UdpSender? replaced)
    {
        if (replaced is not null)
        {
            server.Remove(replaced);
            server.Run++;
        }

        server[isCalculation] = sender;
        sender.Server = server;
    }

    private UdpServer Add(HostKey host)
    {
        var server = new UdpServer(_nextServer++, host);
        _servers.Add(server);
        return server;
    }
}
