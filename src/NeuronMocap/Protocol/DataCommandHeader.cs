using System.Buffers.Binary;

namespace NeuronMocap.Protocol;

/// <summary>
/// The header of an old-generation command packet, which travels on the data connection between motion packets, in both directions
/// (protocol.md sections 2.6 and 7). Of its 40 bytes of parameters two numbers are known; the vendor's client leaves the rest to chance.
/// </summary>
public readonly record struct DataCommandHeader
{
    // Bytes of an entry in a list of bone sizes: a name of 60, a length of 4.
    internal const int BoneSizeEntry = 64;

    /// <summary>Makes the header that the vendor's b12 library sends: version 1.0.0.2, no payload.</summary>
    public DataCommandHeader() => Version = DataVersion.Old;

    /// <summary>Version of the data format.</summary>
    public DataVersion Version { get; init; }

    /// <summary>What the command is about. Servers may send numbers that the enumeration lacks.</summary>
    public DataCommandId CommandId { get; init; }

    /// <summary>Entries of the payload: 64-byte bone sizes for command 0, bytes of text for command 4, else without meaning.</summary>
    public uint DataCount { get; init; }

    /// <summary>
    /// The first parameter. In requests: the avatar, from 0, or for the two event commands the <see cref="DataCommandId"/> to watch. In
    /// replies: the avatar (frequency, combination mode) or the number of avatars.
    /// </summary>
    public int Parameter { get; init; }

    /// <summary>The second parameter, in replies only: frames per second, or the <see cref="SensorCombination"/>.</summary>
    public int Value { get; init; }

    /// <summary>Bytes that follow the header, as command and count say; the length field on the wire is not reliable.</summary>
    public long PayloadSize => CommandId switch
    {
        DataCommandId.BoneSize => DataCount * (long)BoneSizeEntry,
        DataCommandId.BvhText => DataCount,
        _ => 0,
    };

    /// <summary>Reads a header.</summary>
    /// <param name="source">Bytes that start at the first token.</param>
    /// <param name="header">The header, when there is one.</param>
    /// <returns>False when fewer than 64 bytes are given or a token is wrong.</returns>
    public static bool TryRead(ReadOnlySpan<byte> source, out DataCommandHeader header)
    {
        header = default;
        if (!PacketTokens.Match(source, PacketKind.Command))
            return false;

        header = Read(source);
        return true;
    }

    /// <summary>Writes the 64 bytes of the header; parameters without a name are zero.</summary>
    /// <param name="destination">At least 64 bytes.</param>
    public void Write(Span<byte> destination)
    {
        Span<byte> target = destination[..ProtocolConstants.HeaderSize];
        target.Clear();
        PacketTokens.Write(target, PacketKind.Command);
        Version.Write(target[2..]);
        BinaryPrimitives.WriteUInt32LittleEndian(target[6..], (uint)(ProtocolConstants.HeaderSize + PayloadSize));
        BinaryPrimitives.WriteUInt32LittleEndian(target[10..], DataCount);
        BinaryPrimitives.WriteInt32LittleEndian(target[14..], (int)CommandId);
        BinaryPrimitives.WriteInt32LittleEndian(target[18..], Parameter);
        BinaryPrimitives.WriteInt32LittleEndian(target[22..], Value);
    }

    internal static DataCommandHeader Read(ReadOnlySpan<byte> source) => new()
    {
        Version = DataVersion.Read(source[2..]),
        DataCount = BinaryPrimitives.ReadUInt32LittleEndian(source[10..]),
        CommandId = (DataCommandId)BinaryPrimitives.ReadInt32LittleEndian(source[14..]),
        Parameter = BinaryPrimitives.ReadInt32LittleEndian(source[18..]),
        Value = BinaryPrimitives.ReadInt32LittleEndian(source[22..]),
    };
}
