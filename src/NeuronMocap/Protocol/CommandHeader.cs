using System.Buffers.Binary;

namespace NeuronMocap.Protocol;

/// <summary>
/// The header of an old-generation command packet, which travels on the data connection between motion packets
/// (protocol.md sections 2.6 and 7). Its parameters are the 40 bytes at offset 18 of the packet.
/// </summary>
public readonly record struct CommandHeader
{
    /// <summary>Makes the header that the vendor's b12 library sends: version 1.0.0.2, no payload.</summary>
    public CommandHeader() => Version = DataVersion.Old;

    /// <summary>Version of the data format.</summary>
    public DataVersion Version { get; init; }

    /// <summary>Number of the command: 0 bone size to 8 unregister event (protocol.md section 2.4, "CmdId, OLD").</summary>
    public int CommandId { get; init; }

    /// <summary>Entries of the payload: 64-byte bone sizes for command 0, bytes of text for command 4, else without meaning.</summary>
    public uint DataCount { get; init; }

    /// <summary>Bytes that follow the header, as command and count say; the length field on the wire is not reliable.</summary>
    public long PayloadSize => CommandId switch
    {
        0 => DataCount * 64L,
        4 => DataCount,
        _ => 0,
    };

    /// <summary>Reads a header.</summary>
    /// <param name="source">Bytes that start at the first token.</param>
    /// <param name="header">The header, when there is one.</param>
    /// <returns>False when fewer than 64 bytes are given or a token is wrong.</returns>
    public static bool TryRead(ReadOnlySpan<byte> source, out CommandHeader header)
    {
        header = default;
        if (!PacketTokens.Match(source, PacketKind.Command))
            return false;

        header = Read(source);
        return true;
    }

    /// <summary>Writes the 64 bytes of the header, with all parameters zero.</summary>
    /// <param name="destination">At least 64 bytes.</param>
    public void Write(Span<byte> destination)
    {
        Span<byte> target = destination[..ProtocolConstants.HeaderSize];
        target.Clear();
        PacketTokens.Write(target, PacketKind.Command);
        Version.Write(target[2..]);
        BinaryPrimitives.WriteUInt32LittleEndian(target[6..], (uint)(ProtocolConstants.HeaderSize + PayloadSize));
        BinaryPrimitives.WriteUInt32LittleEndian(target[10..], DataCount);
        BinaryPrimitives.WriteInt32LittleEndian(target[14..], CommandId);
    }

    internal static CommandHeader Read(ReadOnlySpan<byte> source) => new()
    {
        Version = DataVersion.Read(source[2..]),
        DataCount = BinaryPrimitives.ReadUInt32LittleEndian(source[10..]),
        CommandId = BinaryPrimitives.ReadInt32LittleEndian(source[14..]),
    };
}
