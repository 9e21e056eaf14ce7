using System.Buffers.Binary;

namespace NeuronMocap.Protocol;

/// <summary>The header of a request or a reply on the command channel, which is a separate TCP connection (protocol.md sections 2.5 and 6).</summary>
/// <remarks>
/// Requests and replies look the same. Only the order of the packets shows which request a reply answers. Some servers also repeat the command's number.
/// </remarks>
public readonly record struct CommandChannelHeader
{
    /// <summary>Size of a header in bytes.</summary>
    public const int Size = 16;

    /// <summary>Offset of the second token.</summary>
    internal const int Token2Offset = 14;

    /// <summary>A field without a known meaning: the vendor's library sends uninitialized memory. It is 0 in new headers.</summary>
    public ushort CommandType { get; init; }

    /// <summary>Number of the command: see <see cref="CommandChannelId"/>. Some servers may not repeat it in a reply.</summary>
    public ushort CommandId { get; init; }

    /// <summary>Number of bytes after the header. The stream can contain any value, so this can be negative or huge.</summary>
    public int PayloadSize { get; init; }

    /// <summary>A field without a known meaning; the same as <see cref="CommandType"/>.</summary>
    public uint Reserved { get; init; }

    /// <summary>Reads a header.</summary>
    /// <param name="source">Bytes that start at the first token.</param>
    /// <param name="header">The header, if the method returns true.</param>
    /// <returns>False if there are fewer than 16 bytes, or if a token is wrong.</returns>
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
    /// <exception cref="ArgumentOutOfRangeException">The destination is too short.</exception>
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
