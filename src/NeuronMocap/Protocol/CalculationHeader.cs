using System.Buffers.Binary;
using NeuronMocap.Protocol;

namespace NeuronMocap;

/// <summary>The header of a calculation packet: see manual section 2.1.4 and protocol.md section 2.3.</summary>
public readonly record struct CalculationHeader
{
    /// <summary>Creates a header of data version 1.0.0.3, as in the manual's example.</summary>
    public CalculationHeader() => Version = DataVersion.Calculation;

    /// <summary>Version of the data format. Unlike the version of a motion header, it has no effect and is not checked.</summary>
    public DataVersion Version { get; init; }

    /// <summary>Number of binary32 values after the header: 338 for 21 bones, 946 for 59 bones.</summary>
    public int ValueCount { get; init; }

    /// <summary>
    /// Number of the avatar on the server, from 0. The number is unsigned in the stream. Numbers from 2³¹ on, which no server uses, are negative here.
    /// </summary>
    public int AvatarIndex { get; init; }

    /// <summary>Name of the avatar.</summary>
    public AvatarName AvatarName { get; init; }

    /// <summary>The server's frame counter; <see cref="MotionHeader.FrameIndex"/> describes its use.</summary>
    public uint FrameIndex { get; init; }

    /// <summary>First reserved field, kept as received.</summary>
    public uint Reserved1 { get; init; }

    /// <summary>Second reserved field, kept as received.</summary>
    public uint Reserved2 { get; init; }

    /// <summary>Third reserved field, kept as received.</summary>
    public uint Reserved3 { get; init; }

    /// <summary>Size of the whole packet in bytes: 64, and 4 for every value.</summary>
    public int PacketSize => ProtocolConstants.HeaderSize + (ValueCount * sizeof(float));

    /// <summary>Reads a header.</summary>
    /// <param name="source">Bytes that start at the first token.</param>
    /// <param name="header">The header, if the method returns true.</param>
    /// <returns>False if there are fewer than 64 bytes, a token is wrong, or the size of the packet exceeds an int.</returns>
    public static bool TryRead(ReadOnlySpan<byte> source, out CalculationHeader header)
    {
        header = default;
        if (!PacketTokens.Match(source, PacketKind.Calculation) || ReadValueCount(source) > ProtocolConstants.MaxValueCount)
            return false;

        header = Read(source);
        return true;
    }

    /// <summary>Writes the 64 bytes of the header.</summary>
    /// <param name="destination">At least 64 bytes.</param>
    /// <exception cref="InvalidOperationException"><see cref="ValueCount"/> is negative.</exception>
    public void Write(Span<byte> destination)
    {
        if (ValueCount < 0)
            throw new InvalidOperationException("The number of values must not be negative.");

        Span<byte> target = destination[..ProtocolConstants.HeaderSize];
        PacketTokens.Write(target, PacketKind.Calculation);
        Version.Write(target[2..]);
        BinaryPrimitives.WriteUInt32LittleEndian(target[6..], (uint)ValueCount);
        BinaryPrimitives.WriteInt32LittleEndian(target[10..], AvatarIndex);
        AvatarName.CopyTo(target[14..]);
        BinaryPrimitives.WriteUInt32LittleEndian(target[46..], FrameIndex);
        BinaryPrimitives.WriteUInt32LittleEndian(target[50..], Reserved1);
        BinaryPrimitives.WriteUInt32LittleEndian(target[54..], Reserved2);
        BinaryPrimitives.WriteUInt32LittleEndian(target[58..], Reserved3);
    }

    // The caller has checked that there are 64 bytes and both tokens.
    internal static CalculationHeader Read(ReadOnlySpan<byte> source) => new()
    {
        Version = DataVersion.Read(source[2..]),
        ValueCount = (int)ReadValueCount(source),
        AvatarIndex = BinaryPrimitives.ReadInt32LittleEndian(source[10..]),
        AvatarName = AvatarName.Read(source[14..]),
        FrameIndex = BinaryPrimitives.ReadUInt32LittleEndian(source[46..]),
        Reserved1 = BinaryPrimitives.ReadUInt32LittleEndian(source[50..]),
        Reserved2 = BinaryPrimitives.ReadUInt32LittleEndian(source[54..]),
        Reserved3 = BinaryPrimitives.ReadUInt32LittleEndian(source[58..]),
    };

    // Reads single fields for the receive path, which does not need the others.
    internal static uint ReadValueCount(ReadOnlySpan<byte> source) => BinaryPrimitives.ReadUInt32LittleEndian(source[6..]);

    internal static uint ReadAvatarIndex(ReadOnlySpan<byte> source) => BinaryPrimitives.ReadUInt32LittleEndian(source[10..]);

    internal static AvatarName ReadAvatarName(ReadOnlySpan<byte> source) => AvatarName.Read(AvatarNameIn(source));

    internal static ReadOnlySpan<byte> AvatarNameIn(ReadOnlySpan<byte> source) => source.Slice(14, ProtocolConstants.AvatarNameSize);

    internal static uint? ReadFrameIndex(ReadOnlySpan<byte> source) =>
        TextLine.IsImage(source) ? null : BinaryPrimitives.ReadUInt32LittleEndian(source[46..]);
}
