using System.Net;
using NeuronMocap.Protocol;

namespace NeuronMocap.Transport;

// One address and port that sends datagrams. Times are clock ticks that the caller provides. Turns count datagrams, so they also order datagrams of the
// same time.
internal sealed class UdpSender
{
    private long _longestPause;

    // Copies the address, because the receive loop reuses its address object for the next datagram.
    public UdpSender(SocketAddress address, int number, SenderIdentity identity, long turn, long clock)
    {
        Address = new SocketAddress(address.Family, address.Size);
        AddressBytes = new byte[address.Size];
        for (int i = 0; i < address.Size; i++)
            Address[i] = AddressBytes[i] = address[i];

        Host = HostKey.Of(Address);
        (Number, Identity, Began, Turn, FirstHeard, Heard) = (number, identity, turn, turn, clock, clock);
    }

    public SocketAddress Address { get; }

    public byte[] AddressBytes { get; }

    public HostKey Host { get; }

    // Number of the sender in recordings; each sender has a different number.
    public int Number { get; }

    public SenderIdentity Identity { get; }

    // Turns and times of the first and the newest datagram.
    public long Began { get; }

    public long Turn { get; private set; }

    public long FirstHeard { get; }

    public long Heard { get; private set; }

    // When its newest frame was complete; null before the first frame.
    public long? Delivered { get; set; }

    // Null until its server is identified, and again after another sender took its place.
    public UdpServer? Server { get; set; }

    // Null until it has a server.
    public PacketAssembler? Assembler { get; set; }

    // Datagrams that wait until it has a server.
    public List<(byte[] Datagram, long Timestamp)> Held { get; } = [];

    // While it has no server: when to check again, unless another datagram arrives earlier.
    public long Due { get; set; } = long.MinValue;

    // One bit for each kind of frame that it has sent.
    public int Kinds { get; set; }

    public bool IsRetired => Assembler is not null && Server is null;

    // The longest of its recent pauses between two datagrams. It decreases slowly, because the avatars of one frame arrive together.
    public long LongestPause => _longestPause;

    public void Hear(long turn, long clock)
    {
        _longestPause = Math.Max(clock - Heard, _longestPause - (_longestPause >> 6));
        (Turn, Heard) = (turn, clock);
    }
}
