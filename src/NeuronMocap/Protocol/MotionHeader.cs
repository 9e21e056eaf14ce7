using System.Buffers.Binary;
using System.Runtime.CompilerServices;
using NeuronMocap.Protocol;

namespace NeuronMocap;

/// <summary>The header of a motion (BVH) packet: see manual section 2.1.3 and protocol.md sections 2.1 (layout New) and 2.2 (layout Old).</summary>
/// <remarks>One type serves both layouts. Fields that a layout does not have are null or zero.</remarks>
public readonly record struct MotionHeader
{
    /// <summary>Creates the header of an Axis Neuron frame: data version 1.1.0.0.</summary>
    public MotionHeader() => Version = DataVersion.New;

    /// <summary>Version of the data format. It determines the layout: 1.0 is Old, everything else is New.</summary>
    public DataVersion Version { get; init; }

    /// <summary>Number of binary32 values after the header: 180, 186, 354 or 360 for the 59 bones.</summary>
    public int ValueCount { get; init; }

    /// <summary>Whether every bone has a position (cm) before its rotation. Otherwise only the hips have one.</summary>
    public bool HasDisplacement { get; init; }

    /// <summary>Whether six values of the Reference node precede the hips.</summary>
    public bool HasReference { get; init; }

    /// <summary>
    /// Number of the avatar on the server, from 0. The number is unsigned in the stream. Numbers from 2³¹ on, which no server uses, are negative here.
    /// </summary>
    public int AvatarIndex { get; init; }

    /// <summary>Name of the avatar.</summary>
    public AvatarName AvatarName { get; init; }

    /// <summary>
    /// The server's frame counter; null in the Old layout, which has none. Use it to count gaps, not for timing. Its first value, where it wraps, and the
    /// effect of frequency reduction are not documented.
    /// </summary>
    public uint? FrameIndex { get; init; }

    /// <summary>First reserved field. Axis Studio writes the rotation order here. The Old layout does not have this field.</summary>
    public uint Reserved { get; init; }

    /// <summary>Second reserved field. Axis Studio writes hours, minutes and seconds of the timecode here.</summary>
    public uint Reserved1 { get; init; }

    /// <summary>Third reserved field. Axis Studio writes the timecode's sub-frame here.</summary>
    public uint Reserved2 { get; init; }

    /// <summary>
    /// The timecode that Axis Studio writes into the reserved fields; null for data versions other than 1.1.0.1.
    /// </summary>
    /// <remarks>
    /// In other data versions, the fields do not hold a time of day. The timecode is also null if both fields are 0, as a server without a clock leaves
    /// them.
    /// </remarks>
    public Timecode? Timecode => Version == DataVersion.Studio ? NeuronMocap.Timecode.Read(Reserved1, Reserved2) : null;

    /// <summary>The layout that corresponds to <see cref="Version"/>.</summary>
    public HeaderLayout Layout => Version.Layout;

    /// <summary>Size of the whole packet in bytes: 64, and 4 for every value.</summary>
    public int PacketSize => ProtocolConstants.HeaderSize + (ValueCount * sizeof(float));

    /// <summary>Reads a header.</summary>
    /// <param name="source">Bytes that start at the first token.</param>
    /// <param name="header">The header, if the method returns true.</param>
    /// <returns>
    /// False if there are fewer than 64 bytes, a token is wrong, the version is unknown, or the size of the packet exceeds an int.
    /// </returns>
    public static bool TryRead(ReadOnlySpan<byte> source, out MotionHeader header)
    {
        header = default;
        if (!PacketTokens.Match(source, PacketKind.Motion)
            || !DataVersion.Read(source[2..]).TryGetLayout(out _)
            || ReadValueCount(source) > ProtocolConstants.MaxValueCount)
        {
            return false;
        }

        header = Read(source);
        return true;
    }

    /// <summary>Writes the 64 bytes of the header, in the layout that corresponds to <see cref="Version"/>.</summary>
    /// <param name="destination">At least 64 bytes.</param>
    /// <exception cref="InvalidOperationException">
    /// <see cref="ValueCount"/> does not fit the layout: it must be 0 to 65,535 in New, and not negative in Old.
    /// </exception>
    public void Write(Span<byte> destination)
    {
        Span<byte> target = destination[..ProtocolConstants.HeaderSize];
        target.Clear();
        PacketTokens.Write(target, PacketKind.Motion);
        Version.Write(target[2..]);
        if (Layout == HeaderLayout.New)
            WriteNew(target);
        else
            WriteOld(target);
    }

    // The caller has checked that there are 64 bytes and both tokens.
    internal static MotionHeader Read(ReadOnlySpan<byte> source)
    {
        DataVersion version = DataVersion.Read(source[2..]);
        return version.Layout == HeaderLayout.Old ? ReadOld(source, version) : ReadNew(source, version);
    }

    // Reads single fields for the receive path, which does not need the others.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static uint ReadValueCount(ReadOnlySpan<byte> source) => DataVersion.IsOld(source[2..])
        ? BinaryPrimitives.ReadUInt32LittleEndian(source[6..])
        : BinaryPrimitives.ReadUInt16LittleEndian(source[6..]);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static uint ReadAvatarIndex(ReadOnlySpan<byte> source) => DataVersion.IsOld(source[2..])
        ? BinaryPrimitives.ReadUInt32LittleEndian(source[18..])
        : BinaryPrimitives.ReadUInt32LittleEndian(source[10..]);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static AvatarName ReadAvatarName(ReadOnlySpan<byte> source) => AvatarName.Read(AvatarNameIn(source));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static ReadOnlySpan<byte> AvatarNameIn(ReadOnlySpan<byte> source) => DataVersion.IsOld(source[2..])
        ? source.Slice(22, ProtocolConstants.AvatarNameSize)
        : source.Slice(14, ProtocolConstants.AvatarNameSize);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static uint? ReadFrameIndex(ReadOnlySpan<byte> source) =>
        DataVersion.IsOld(source[2..]) ? null : BinaryPrimitives.ReadUInt32LittleEndian(source[46..]);

    // Writes single fields into a header that was written before. The Old layout has no number of the frame.
    internal static void WriteFrameIndex(Span<byte> header, uint index)
    {
        if (!DataVersion.IsOld(header[2..]))
            BinaryPrimitives.WriteUInt32LittleEndian(header[46..], index);
    }

    internal static void WriteTimecode(Span<byte> header, uint time, uint subFrame)
    {
        BinaryPrimitives.WriteUInt32LittleEndian(header[54..], time);
        BinaryPrimitives.WriteUInt32LittleEndian(header[58..], subFrame);
    }

    private static MotionHeader ReadNew(ReadOnlySpan<byte> source, DataVersion version) => new()
    {
        Version = version,
        ValueCount = BinaryPrimitives.ReadUInt16LittleEndian(source[6..]),
        HasDisplacement = source[8] != 0,
        HasReference = source[9] != 0,
        AvatarIndex = BinaryPrimitives.ReadInt32LittleEndian(source[10..]),
        AvatarName = AvatarName.Read(source[14..]),
        FrameIndex = BinaryPrimitives.ReadUInt32LittleEndian(source[46..]),
        Reserved = BinaryPrimitives.ReadUInt32LittleEndian(source[50..]),
        Reserved1 = BinaryPrimitives.ReadUInt32LittleEndian(source[54..]),
        Reserved2 = BinaryPrimitives.ReadUInt32LittleEndian(source[58..]),
    };

    private static MotionHeader ReadOld(ReadOnlySpan<byte> source, DataVersion version) => new()
    {
        Version = version,
        ValueCount = (int)BinaryPrimitives.ReadUInt32LittleEndian(source[6..]),
        HasDisplacement = BinaryPrimitives.ReadUInt32LittleEndian(source[10..]) != 0,
        HasReference = BinaryPrimitives.ReadUInt32LittleEndian(source[14..]) != 0,
        AvatarIndex = BinaryPrimitives.ReadInt32LittleEndian(source[18..]),
        AvatarName = AvatarName.Read(source[22..]),
        Reserved1 = BinaryPrimitives.ReadUInt32LittleEndian(source[54..]),
        Reserved2 = BinaryPrimitives.ReadUInt32LittleEndian(source[58..]),
    };

    private void WriteNew(Span<byte> target)
    {
        if (ValueCount is < 0 or > ushort.MaxValue)
            throw new InvalidOperationException($"The New layout counts its values in 16 bits; {ValueCount} do not fit.");

        BinaryPrimitives.WriteUInt16LittleEndian(target[6..], (ushort)ValueCount);
        target[8] = HasDisplacement ? (byte)1 : (byte)0;
        target[9] = HasReference ? (byte)1 : (byte)0;
        BinaryPrimitives.WriteInt32LittleEndian(target[10..], AvatarIndex);
        AvatarName.CopyTo(target[14..]);
        BinaryPrimitives.WriteUInt32LittleEndian(target[46..], FrameIndex ?? 0);
        BinaryPrimitives.WriteUInt32LittleEndian(target[50..], Reserved);
        BinaryPrimitives.WriteUInt32LittleEndian(target[54..], Reserved1);
        BinaryPrimitives.WriteUInt32LittleEndian(target[58..], Reserved2);
    }

    private void WriteOld(Span<byte> target)
    {
        if (ValueCount < 0)
            throw new InvalidOperationException("The number of values must not be negative.");

        BinaryPrimitives.WriteUInt32LittleEndian(target[6..], (uint)ValueCount);
        BinaryPrimitives.WriteUInt32LittleEndian(target[10..], HasDisplacement ? 1u : 0u);
        BinaryPrimitives.WriteUInt32LittleEndian(target[14..], HasReference ? 1u : 0u);
        BinaryPrimitives.WriteInt32LittleEndian(target[18..], AvatarIndex);
        AvatarName.CopyTo(target[22..]);
        BinaryPrimitives.WriteUInt32LittleEndian(target[54..], Reserved1);
        BinaryPrimitives.WriteUInt32LittleEndian(target[58..], Reserved2);
    }
}
