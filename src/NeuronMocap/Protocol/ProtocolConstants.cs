namespace NeuronMocap.Protocol;

/// <summary>Sizes, limits and ports of the wire protocol (protocol.md sections 2 and 4.3).</summary>
public static class ProtocolConstants
{
    /// <summary>Bytes of every packet header on a data connection, of either layout.</summary>
    public const int HeaderSize = 64;

    /// <summary>Bytes of the avatar name inside a header. A name that fills them has no terminator.</summary>
    public const int AvatarNameSize = 32;

    /// <summary>Where the second token of every header stands.</summary>
    internal const int Token2Offset = HeaderSize - 2;

    // With more values the size of a packet does not fit an int.
    internal const int MaxValueCount = (int.MaxValue - HeaderSize) / sizeof(float);

    /// <summary>TCP port on which Axis Neuron broadcasts BVH data unless told otherwise.</summary>
    public const int DefaultPort = 7001;

    /// <summary>TCP port on which Axis Neuron usually broadcasts calculation data (protocol.md section 4.3).</summary>
    public const int DefaultCalculationPort = 7003;

    /// <summary>
    /// TCP port of the command channel unless told otherwise. A setting of the server, which the manual gives no default for: 8013 is the port that
    /// a public client names (protocol.md section 4.3).
    /// </summary>
    public const int DefaultCommandPort = 8013;

    /// <summary>
    /// Floats in the largest packet that the vendor's library can deliver (a receive buffer of 40,960 bytes, protocol.md section 5).
    /// Real packets carry at most 946; a header that announces more than the limit is garbage or an attack.
    /// </summary>
    public const int DefaultMaxValues = 10_224;

    /// <summary>Largest payload of a command packet, in bytes: the vendor's MAX_PACKETSIZE.</summary>
    public const int MaxCommandPayload = 100_000;

    /// <summary>
    /// Largest payload of a reply on the command channel that the vendor's library takes anywhere, in bytes: its command packet where a long has
    /// 8 bytes (protocol.md section 2.5).
    /// </summary>
    public const int MaxCommandReply = 200_016;

    // Both bytes of a token are given in wire order. Two bytes start all tokens, which vectorises the search for one.
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
