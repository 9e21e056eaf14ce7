using System.Buffers.Binary;

namespace NeuronMocap.Protocol;

/// <summary>
/// The header of a command packet of the old generation. It travels in both directions on the data connection, between motion packets (protocol.md
/// sections 2.6 and 7).
/// </summary>
/// <remarks>Only two numbers in its 40 bytes of parameters are known. The vendor's client does not initialize the rest.</remarks>
public readonly record struct DataCommandHeader
{
    // Size of an entry in a list of bone sizes: 60 bytes of name, 4 bytes of length.
    internal const int BoneSizeEntry = 64;

    /// <summary>Creates a header as the vendor's b12 library sends it: version 1.0.0.2, no payload.</summary>
    public DataCommandHeader() => Version = DataVersion.Old;

    /// <summary>Version of the data format.</summary>
    public DataVersion Version { get; init; }

    /// <summary>The value that the command is about. Servers can send numbers that the enumeration does not contain.</summary>
    public DataCommandId CommandId { get; init; }

    /// <summary>
    /// Number of entries of the payload: bone sizes of 64 bytes for command 0, bytes of text for command 4. It has no meaning for other commands.
    /// </summary>
    public uint DataCount { get; init; }

    /// <summary>The first parameter.</summary>
    /// <remarks>
    /// In requests it is the avatar, from 0; for the two event commands it is the <see cref="DataCommandId"/> to watch. In replies it is the avatar
    /// (frequency, combination mode) or the number of avatars.
    /// </remarks>
    public int Parameter { get; init; }

    /// <summary>The second parameter, in replies only: frames per second, or the <see cref="Commands.CombinationMode"/>.</summary>
    public int Value { get; init; }

    /// <summary>
    /// Number of bytes after the header, computed from the command and the count. The length field in the stream is not reliable.
    /// </summary>
    public long PayloadSize => CommandId switch
    {
        DataCommandId.BoneSize => DataCount * (long)BoneSizeEntry,
        DataCommandId.BvhText => DataCount,
        _ => 0,
    };

    /// <summary>Reads a header.</summary>
    /// <param name="source">Bytes that start at the first token.</param>
    /// <param name="header">The header, if the method returns true.</param>
    /// <returns>False if there are fewer than 64 bytes, or if a token is wrong.</returns>
    public static bool TryRead(ReadOnlySpan<byte> source, out DataCommandHeader header)
    {
        header = default;
        if (!PacketTokens.Match(source, PacketKind.Command))
            return false;

        header = Read(source);
        return true;
    }

    /// <summary>Writes the 64 bytes of the header; parameters without a known meaning are zero.</summary>
    /// <param name="destination">At least 64 bytes.</param>
    public void Write(Span<byte> destination)
    {
        Span<byte> target = destination[..ProtocolConstants.HeaderSize];
        target.Clear();
        PacketTokens.Write(target, PacketKind.Command);
        Version.Write(target[2..]);
        BinaryPrimitives.WriteUInt32LittleEndian(target[6..], (uint)(ProtocolConstants.HeaderSize + PayloadSize));
        BinaryPrimitives.WriteUInt32LittleEndian(target[10..], DataCount);
        WriteCommand(target, CommandId);
        BinaryPrimitives.WriteInt32LittleEndian(target[18..], Parameter);
        BinaryPrimitives.WriteInt32LittleEndian(target[22..], Value);
    }

    // Replaces the command of a header in bytes.
    internal static void WriteCommand(Span<byte> header, DataCommandId command) => BinaryPrimitives.WriteInt32LittleEndian(header[14..], (int)command);

    internal static DataCommandHeader Read(ReadOnlySpan<byte> source) => new()
    {
        Version = DataVersion.Read(source[2..]),
        DataCount = BinaryPrimitives.ReadUInt32LittleEndian(source[10..]),
        CommandId = (DataCommandId)BinaryPrimitives.ReadInt32LittleEndian(source[14..]),
        Parameter = BinaryPrimitives.ReadInt32LittleEndian(source[18..]),
        Value = BinaryPrimitives.ReadInt32LittleEndian(source[22..]),
    };
}
