using System.Buffers.Binary;
using NeuronMocap.Protocol;

namespace NeuronMocap;

/// <summary>The header of Axis Studio's calculation packet, token 0xDCCF: protocol.md section 9.</summary>
public readonly record struct StudioCalculationHeader
{
    /// <summary>Value of <see cref="DataMask"/> in the packets whose layout is known: all seven groups of values of each bone.</summary>
    public const uint FullDataMask = 0xFE;

    /// <summary>Makes the header that Axis Studio sends: version 2.0.0.0, all groups of values.</summary>
    public StudioCalculationHeader()
    {
        Version = DataVersion.StudioCalculation;
        DataMask = FullDataMask;
    }

    /// <summary>Version of the data format. The layout of the values is known for 2.0 only.</summary>
    public DataVersion Version { get; init; }

    /// <summary>Number of bytes, not of values, that follow the header: 4956 for 59 bones.</summary>
    public int ByteCount { get; init; }

    /// <summary>Number of the avatar on the server, from 0. The wire has no sign; numbers from 2³¹ on, which no server uses, are negative here.</summary>
    public int AvatarIndex { get; init; }

    /// <summary>Name of the avatar.</summary>
    public AvatarName AvatarName { get; init; }

    /// <summary>The server's frame counter; see <see cref="MotionHeader.FrameIndex"/> for what it is good for.</summary>
    public uint FrameIndex { get; init; }

    /// <summary>The category field, kept as received; its meaning is not documented.</summary>
    public uint Category { get; init; }

    /// <summary>Which groups of values each bone carries; <see cref="FullDataMask"/> in all captures.</summary>
    public uint DataMask { get; init; }

    /// <summary>The reserved field, kept as received.</summary>
    public uint Reserved { get; init; }

    /// <summary>Bytes of the whole packet.</summary>
    public int PacketSize => ProtocolConstants.HeaderSize + ByteCount;

    /// <summary>Reads a header.</summary>
    /// <param name="source">Bytes that start at the first token.</param>
    /// <param name="header">The header, when there is one.</param>
    /// <returns>False when fewer than 64 bytes are given, a token is wrong or the packet would have more bytes than an int counts.</returns>
    public static bool TryRead(ReadOnlySpan<byte> source, out StudioCalculationHeader header)
    {
        header = default;
        if (!PacketTokens.Match(source, PacketKind.StudioCalculation) || ReadByteCount(source) > int.MaxValue - ProtocolConstants.HeaderSize)
            return false;

        header = Read(source);
        return true;
    }

    /// <summary>Writes the 64 bytes of the header.</summary>
    /// <param name="destination">At least 64 bytes.</param>
    /// <exception cref="InvalidOperationException"><see cref="ByteCount"/> is negative.</exception>
    public void Write(Span<byte> destination)
    {
        if (ByteCount < 0)
            throw new InvalidOperationException("The number of bytes must not be negative.");

        Span<byte> target = destination[..ProtocolConstants.HeaderSize];
        PacketTokens.Write(target, PacketKind.StudioCalculation);
        Version.Write(target[2..]);
        BinaryPrimitives.WriteUInt32LittleEndian(target[6..], (uint)ByteCount);
        BinaryPrimitives.WriteInt32LittleEndian(target[10..], AvatarIndex);
        AvatarName.CopyTo(target[14..]);
        BinaryPrimitives.WriteUInt32LittleEndian(target[46..], FrameIndex);
        BinaryPrimitives.WriteUInt32LittleEndian(target[50..], Category);
        BinaryPrimitives.WriteUInt32LittleEndian(target[54..], DataMask);
        BinaryPrimitives.WriteUInt32LittleEndian(target[58..], Reserved);
    }

    // The caller has seen 64 bytes and both tokens.
    internal static StudioCalculationHeader Read(ReadOnlySpan<byte> source) => new()
    {
        Version = DataVersion.Read(source[2..]),
        ByteCount = (int)ReadByteCount(source),
        AvatarIndex = (int)ReadAvatarIndex(source),
        AvatarName = ReadAvatarName(source),
        FrameIndex = ReadFrameIndex(source),
        Category = BinaryPrimitives.ReadUInt32LittleEndian(source[50..]),
        DataMask = BinaryPrimitives.ReadUInt32LittleEndian(source[54..]),
        Reserved = BinaryPrimitives.ReadUInt32LittleEndian(source[58..]),
    };

    // Single fields, for the receive path, which does not need the others.
    internal static uint ReadByteCount(ReadOnlySpan<byte> source) => BinaryPrimitives.ReadUInt32LittleEndian(source[6..]);

    internal static uint ReadAvatarIndex(ReadOnlySpan<byte> source) => BinaryPrimitives.ReadUInt32LittleEndian(source[10..]);

    internal static AvatarName ReadAvatarName(ReadOnlySpan<byte> source) => AvatarName.Read(source[14..]);

    internal static uint ReadFrameIndex(ReadOnlySpan<byte> source) => BinaryPrimitives.ReadUInt32LittleEndian(source[46..]);
}
