using System.Buffers.Binary;

namespace NeuronMocap.Protocol;

/// <summary>
/// The header of a request or a reply on the command channel, a TCP connection of its own (protocol.md sections 2.5 and 6). Requests and replies
/// look the same; nothing but its place in the conversation, and the command's number where the server repeats it, says what a reply answers.
/// </summary>
public readonly record struct CommandChannelHeader
{
    /// <summary>Bytes of a header.</summary>
    public const int Size = 16;

    /// <summary>Where the second token stands.</summary>
    internal const int Token2Offset = 14;

    /// <summary>Without a known meaning: the vendor's library sends what its memory holds. 0 in what is made here.</summary>
    public ushort CommandType { get; init; }

    /// <summary>Number of the command, see <see cref="CommandChannelId"/>; not every server need repeat it in a reply.</summary>
    public ushort CommandId { get; init; }

    /// <summary>Bytes that follow the header; the wire can say anything, and so this can be negative or huge.</summary>
    public int PayloadSize { get; init; }

    /// <summary>Without a meaning; as <see cref="CommandType"/>.</summary>
    public uint Reserved { get; init; }

    /// <summary>Reads a header.</summary>
    /// <param name="source">Bytes that start at the first token.</param>
    /// <param name="header">The header, when there is one.</param>
    /// <returns>False when fewer than 16 bytes are given or a token is wrong.</returns>
    public static bool TryRead(ReadOnlySpan<byte> source, out CommandChannelHeader header)
    {
        header = default;
        if (source.Length < Size || !HasTokens(source))
            return false;

        header = new CommandChannelHeader
        {
            CommandType = BinaryPrimitives.ReadUInt16LittleEndian(source[2..]),
            CommandId = BinaryPrimitives.ReadUInt16LittleEndian(source[4..]),
            PayloadSize = BinaryPrimitives.ReadInt32LittleEndian(source[6..]),
            Reserved = BinaryPrimitives.ReadUInt32LittleEndian(source[10..]),
        };
        return true;
    }

    /// <summary>Writes the 16 bytes of the header.</summary>
    /// <param name="destination">At least 16 bytes.</param>
    /// <exception cref="ArgumentOutOfRangeException">There are fewer.</exception>
    public void Write(Span<byte> destination)
    {
        Span<byte> target = destination[..Size];
        target[0] = ProtocolConstants.TokenStart;
        target[1] = ProtocolConstants.CommandToken1;
        BinaryPrimitives.WriteUInt16LittleEndian(target[2..], CommandType);
        BinaryPrimitives.WriteUInt16LittleEndian(target[4..], CommandId);
        BinaryPrimitives.WriteInt32LittleEndian(target[6..], PayloadSize);
        BinaryPrimitives.WriteUInt32LittleEndian(target[10..], Reserved);
        target[Token2Offset] = ProtocolConstants.TokenStart;
        target[Token2Offset + 1] = ProtocolConstants.CommandToken2;
    }

    private static bool HasTokens(ReadOnlySpan<byte> source) =>
        source[0] == ProtocolConstants.TokenStart
        && source[1] == ProtocolConstants.CommandToken1
        && source[Token2Offset] == ProtocolConstants.TokenStart
        && source[Token2Offset + 1] == ProtocolConstants.CommandToken2;
}
