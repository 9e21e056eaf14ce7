namespace NeuronMocap.Server.Broadcasting;

/// <summary>Spreads the packets of a frame over the time of the frame.</summary>
/// <remarks>
/// The vendor's b15 and b17 libraries parse each receive on its own and look for the next packet 64 bytes behind each motion packet. When packets
/// arrive together, they lose every other packet and all calculation data (protocol.md section 5). When packets arrive apart, nothing is lost.
/// </remarks>
internal readonly struct PacketSpacing
{
    /// <summary>Minimum time between two packets in milliseconds, unless their frame is late.</summary>
    public const int MinSpacing = 1;

    // A wait for the next packet is rounded up to a whole millisecond, and a thread wakes late. With less room every frame would be late. With more
    // room the last avatars would be late.
    private const double Spacing = 2;

    private readonly double _spacing;

    /// <summary>Decides whether packets are spread, and how far.</summary>
    /// <param name="rate">Frames per second.</param>
    /// <param name="packets">Packets of a frame, on the port that has the most.</param>
    public PacketSpacing(double rate, int packets)
    {
        double room = 1000 / (rate * packets);
        IsPacketwise = room >= Spacing;
        _spacing = Spacing * rate / 1000;
    }

    /// <summary>
    /// Whether there is time to send every packet separately. If not, at test rates or with very many avatars, all packets of a frame appear
    /// together.
    /// </summary>
    public bool IsPacketwise { get; }

    /// <summary>Gets the time at which a packet is due.</summary>
    /// <param name="frame">Number of the frame of the packet.</param>
    /// <param name="place">Index of the packet in the frame, from 0.</param>
    /// <returns>The time in frames.</returns>
    public double GetTime(long frame, int place) => frame + (place * _spacing);
}
