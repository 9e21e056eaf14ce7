using System.Diagnostics;

namespace NeuronMocap.Transport;

// Numbers the servers that send datagrams. A server has an address, one port that motion comes from and one that calculation data comes from, often
// the same. A new port of a known address is one of three things, and which one shows in time:
// - the same server restarted, which never sends from its old port again: the old one stays silent, and the new one goes on under its number;
// - another server of the same computer: both send, and the new one gets a number of its own;
// - the other kind of data of a server, which joins it at once.
// Who cannot be told yet is asked for again later; the caller keeps its datagrams. Not thread-safe.
internal sealed class UdpServers
{
    // A live server may pause for so long: some of its own pauses, within bounds. Networks and busy computers hold datagrams up for a tenth of a
    // second; nobody waits for longer than the upper bound.
    private const int Pauses = 4;
    private static readonly long ShortestSilence = Stopwatch.Frequency / 4;
    private static readonly long LongestSilence = Stopwatch.Frequency;

    private readonly List<UdpServer> _servers = [];
    private int _nextServer;
    private int _nextNumber;
    private long _turn;

    public long NextTurn() => ++_turn;

    public int NextNumber() => _nextNumber++;

    public bool Knows(HostKey host) => _servers.Exists(server => server.Host == host);

    // False while it cannot be told; not where it must be decided, because nobody can wait. Replaced: who sent under this number before.
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
                sender.Due = Math.Min(sender.Due, holder.Heard + SilenceOf(holder, isLast: false));
            }
        }

        if (best.Server is null && isOpen && !isLast)
            return false;

        replaced = best.Server?[isCalculation];
        Place(sender, best.Server ?? Add(sender.Host), isCalculation, replaced);
        return true;
    }

    // A sender sends another kind of data than before. True when its frames are from here on those of another server than it was taken for, or go on
    // for a sender that is gone.
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

    // Of several servers of a computer, the one with the same avatar, and rather one that lacks what comes than one that never sent it.
    private static int RankOf(UdpServer server, UdpSender? holder, UdpSender sender) =>
        (server.Any!.Identity.IsOfSameAvatar(sender.Identity) ? 2 : 0) + (holder is null ? 0 : 1);

    // One that spoke since the other came lives beside it. Where nothing more will come to tell, some datagrams without a word of it have to do.
    private static bool IsGone(UdpSender holder, UdpSender sender, long clock, bool isLast) => holder.Turn < sender.Began
        && (clock - holder.Heard > SilenceOf(holder, isLast) || (isLast && sender.Held.Count > Pauses));

    private static long SilenceOf(UdpSender sender, bool isLast) =>
        Math.Min(Math.Max(Pauses * sender.LongestPause, isLast ? 0 : ShortestSilence), LongestSilence);

    // Whatever else the one sent who is gone, it sends no more.
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
