namespace NeuronMocap.Protocol;

/// <summary>Sizes, limits and ports of the protocol (protocol.md sections 2 and 4.3).</summary>
public static class ProtocolConstants
{
    /// <summary>Size in bytes of every packet header on a data connection, in both layouts.</summary>
    public const int HeaderSize = 64;

    /// <summary>Size in bytes of the avatar name in a header. A name of this length has no terminator.</summary>
    public const int AvatarNameSize = 32;

    /// <summary>Offset of the second token of every header.</summary>
    internal const int Token2Offset = HeaderSize - 2;

    // With more values, the size of a packet exceeds an int.
    internal const int MaxValueCount = (int.MaxValue - HeaderSize) / sizeof(float);

    /// <summary>Default TCP port on which Axis Neuron broadcasts BVH data.</summary>
    public const int DefaultPort = 7001;

    /// <summary>TCP port on which Axis Neuron usually broadcasts calculation data (protocol.md section 4.3).</summary>
    public const int DefaultCalculationPort = 7003;

    /// <summary>
    /// Default TCP port of the command channel. It is a setting of the server, and the manual gives no default. A public client uses port 8013
    /// (protocol.md section 4.3).
    /// </summary>
    public const int DefaultCommandPort = 8013;

    /// <summary>
    /// Number of floats in the largest packet that the vendor's library can deliver, with its receive buffer of 40,960 bytes (protocol.md section 5). Real
    /// packets have at most 946 values; a header that announces more than the limit is garbage or an attack.
    /// </summary>
    public const int DefaultMaxValues = 10_224;

    // The largest limit that options accept.
    internal const int LargestMaxValues = 1_000_000;

    /// <summary>Largest payload of a command packet, in bytes: the vendor's MAX_PACKETSIZE.</summary>
    public const int MaxCommandPayload = 100_000;

    /// <summary>
    /// Largest payload in bytes of a reply on the command channel that any build of the vendor's library accepts. It is that of the command
    /// packet on systems whose long has 8 bytes (protocol.md section 2.5).
    /// </summary>
    public const int MaxCommandReply = 200_016;

    // Both bytes of a token are given in stream order. Only two byte values start all tokens, so the search for one can be vectorized.
    internal const byte TokenStart = 0xFF;
    internal const byte MotionToken1 = 0xDD;
    internal const byte MotionToken2 = 0xEE;
    internal const byte CalculationToken1 = 0x88;
    internal const byte CalculationToken2 = 0x99;
    internal const byte CommandToken1 = 0xAA;
    internal const byte CommandToken2 = 0xBB;
    internal const byte StudioTokenStart = 0xCF;
    internal const byte StudioToken1 = 0xDC;
    internal const byte StudioToken2 = 0xEC;
}
