namespace NeuronMocap.Server.Broadcasting;

/// <summary>
/// How the packets of a frame are spread over its time. The vendor's b15 and b17 libraries parse every receive alone, and look 64 bytes behind each motion packet
/// for the next: of packets that arrive together they lose every other one, and all calculation data (protocol.md section 5). Apart, nothing is lost.
/// </summary>
internal readonly struct PacketSpacing
{
    /// <summary>Milliseconds that two packets are apart at least, unless their frame is late.</summary>
    public const int MinSpacing = 1;

    // A wait for the next packet is rounded up to a whole millisecond, and a thread wakes late: with less room every frame would be late. With more, the last
    // avatars would be.
    private const double Spacing = 2;

    private readonly double _spacing;

    /// <summary>Decides.</summary>
    /// <param name="rate">Frames per second.</param>
    /// <param name="packets">Packets of a frame, on the port that has the most.</param>
    public PacketSpacing(double rate, int packets)
    {
        double room = 1000 / (rate * packets);
        IsPacketwise = room >= Spacing;
        _spacing = Spacing * rate / 1000;
    }

    /// <summary>
    /// Whether there is time for every packet. Else, at rates for tests and with very many avatars, all packets of a frame appear together.
    /// </summary>
    public bool IsPacketwise { get; }

    /// <summary>When a packet is due.</summary>
    /// <param name="frame">Number of its frame.</param>
    /// <param name="place">Its place in the frame, from 0.</param>
    /// <returns>In frames.</returns>
    public double GetTime(long frame, int place) => frame + (place * _spacing);
}
