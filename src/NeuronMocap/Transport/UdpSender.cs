using System.Net;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// One address and port that sends datagrams. Times are ticks of the clock of those who tell them; turns count datagrams, and so tell which came
// first where two came at the same time.
internal sealed class UdpSender
{
    private long _longestPause;

    // The receive loop uses its address object again for the next datagram.
    public UdpSender(SocketAddress address, int number, SenderIdentity identity, long turn, long clock)
    {
        Address = new SocketAddress(address.Family, address.Size);
        AddressBytes = new byte[address.Size];
        for (int i = 0; i < address.Size; i++)
            Address[i] = AddressBytes[i] = address[i];

        Host = HostKey.Of(Address);
        (Number, Identity, Began, Turn, Heard) = (number, identity, turn, turn, clock);
    }

    public SocketAddress Address { get; }

    public byte[] AddressBytes { get; }

    public HostKey Host { get; }

    // What recordings call it; no two have the same.
    public int Number { get; }

    public SenderIdentity Identity { get; }

    // Turns of its first and of its newest datagram, and when the newest came.
    public long Began { get; }

    public long Turn { get; private set; }

    public long Heard { get; private set; }

    // When its newest frame was whole; null before the first one.
    public long? Delivered { get; set; }

    // Null while it is not known whose place it takes, and again when another one has taken its own.
    public UdpServer? Server { get; set; }

    // Null until it has a server.
    public PacketAssembler? Assembler { get; set; }

    // Datagrams that wait until it has one.
    public List<(byte[] Datagram, long Timestamp)> Held { get; } = [];

    // While it has none: when to look again, unless somebody speaks before.
    public long Due { get; set; } = long.MinValue;

    // One bit for each kind of frame that it sent.
    public int Kinds { get; set; }

    public bool IsRetired => Assembler is not null && Server is null;

    // The longest of its recent pauses between two datagrams. It falls slowly: the avatars of one frame come at once.
    public long LongestPause => _longestPause;

    public void Hear(long turn, long clock)
    {
        _longestPause = Math.Max(clock - Heard, _longestPause - (_longestPause >> 6));
        (Turn, Heard) = (turn, clock);
    }
}
