using System.Buffers.Binary;
using NeuronMocap.Protocol;

namespace NeuronMocap;

/// <summary>The header of Axis Studio's calculation packet, token 0xDCCF: see protocol.md section 9.</summary>
public readonly record struct StudioCalculationHeader
{
    /// <summary>Value of <see cref="DataMask"/> in packets with the known layout: all seven groups of values for each bone.</summary>
    public const uint FullDataMask = 0xFE;

    /// <summary>Creates a header as Axis Studio sends it: version 2.0.0.0, all groups of values.</summary>
    public StudioCalculationHeader()
    {
        Version = DataVersion.StudioCalculation;
        DataMask = FullDataMask;
    }

    /// <summary>Version of the data format. The layout of the values is known only for 2.0.</summary>
    public DataVersion Version { get; init; }

    /// <summary>Number of bytes, not of values, after the header: 4956 for 59 bones.</summary>
    public int ByteCount { get; init; }

    /// <summary>
    /// Number of the avatar on the server, from 0. The number is unsigned in the stream. Numbers from 2³¹ on, which no server uses, are negative here.
    /// </summary>
    public int AvatarIndex { get; init; }

    /// <summary>Name of the avatar.</summary>
    public AvatarName AvatarName { get; init; }

    /// <summary>The server's frame counter; <see cref="MotionHeader.FrameIndex"/> describes its use.</summary>
    public uint FrameIndex { get; init; }

    /// <summary>The category field, kept as received; its meaning is not documented.</summary>
    public uint Category { get; init; }

    /// <summary>The groups of values that each bone has; <see cref="FullDataMask"/> in all captures.</summary>
    public uint DataMask { get; init; }

    /// <summary>The reserved field, kept as received.</summary>
    public uint Reserved { get; init; }

    /// <summary>Size of the whole packet in bytes.</summary>
    public int PacketSize => ProtocolConstants.HeaderSize + ByteCount;

    /// <summary>Reads a header.</summary>
    /// <param name="source">Bytes that start at the first token.</param>
    /// <param name="header">The header, if the method returns true.</param>
    /// <returns>False if there are fewer than 64 bytes, a token is wrong, or the size of the packet exceeds an int.</returns>
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

    // The caller has checked that there are 64 bytes and both tokens.
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

    // Reads single fields for the receive path, which does not need the others.
    internal static uint ReadByteCount(ReadOnlySpan<byte> source) => BinaryPrimitives.ReadUInt32LittleEndian(source[6..]);

    internal static uint ReadAvatarIndex(ReadOnlySpan<byte> source) => BinaryPrimitives.ReadUInt32LittleEndian(source[10..]);

    internal static AvatarName ReadAvatarName(ReadOnlySpan<byte> source) => AvatarName.Read(source[14..]);

    internal static uint ReadFrameIndex(ReadOnlySpan<byte> source) => BinaryPrimitives.ReadUInt32LittleEndian(source[46..]);
}
