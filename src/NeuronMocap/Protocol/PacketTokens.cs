using System.Buffers.Binary;
using System.Runtime.CompilerServices;

namespace NeuronMocap.Protocol;

// The pair of tokens that encloses every header: two bytes at offset 0, and two at offset 62.
internal static class PacketTokens
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static PacketKind KindOf(byte start, byte token1) => start switch
    {
        ProtocolConstants.TokenStart => token1 switch
        {
            ProtocolConstants.MotionToken1 => PacketKind.Motion,
            ProtocolConstants.CalculationToken1 => PacketKind.Calculation,
            ProtocolConstants.CommandToken1 => PacketKind.Command,
            _ => PacketKind.None,
        },
        ProtocolConstants.StudioTokenStart when token1 == ProtocolConstants.StudioToken1 => PacketKind.StudioCalculation,
        _ => PacketKind.None,
    };

    // The caller has checked that there are 64 bytes.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static PacketKind KindOf(ReadOnlySpan<byte> header)
    {
        PacketKind kind = KindOf(header[0], header[1]);
        return kind != PacketKind.None && HasToken2(header, kind) ? kind : PacketKind.None;
    }

    // The caller has checked that there are 64 bytes.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsMotion(ReadOnlySpan<byte> header) =>
        BinaryPrimitives.ReadUInt16BigEndian(header) == ((ProtocolConstants.TokenStart << 8) | ProtocolConstants.MotionToken1)
        && BinaryPrimitives.ReadUInt16BigEndian(header[ProtocolConstants.Token2Offset..]) == ((ProtocolConstants.TokenStart << 8) | ProtocolConstants.MotionToken2);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsStart(byte value) => value is ProtocolConstants.TokenStart or ProtocolConstants.StudioTokenStart;

    public static bool Match(ReadOnlySpan<byte> source, PacketKind kind) =>
        source.Length >= ProtocolConstants.HeaderSize && KindOf(source) == kind;

    public static void Write(Span<byte> header, PacketKind kind)
    {
        header[0] = Start(kind);
        header[1] = Token1(kind);
        header[ProtocolConstants.Token2Offset] = Start(kind);
        header[ProtocolConstants.Token2Offset + 1] = Token2(kind);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool HasToken2(ReadOnlySpan<byte> header, PacketKind kind) =>
        header[ProtocolConstants.Token2Offset] == header[0]
        && header[ProtocolConstants.Token2Offset + 1] == Token2(kind);

    private static byte Start(PacketKind kind) =>
        kind == PacketKind.StudioCalculation ? ProtocolConstants.StudioTokenStart : ProtocolConstants.TokenStart;

    private static byte Token1(PacketKind kind) => kind switch
    {
        PacketKind.Motion => ProtocolConstants.MotionToken1,
        PacketKind.Calculation => ProtocolConstants.CalculationToken1,
        PacketKind.StudioCalculation => ProtocolConstants.StudioToken1,
        _ => ProtocolConstants.CommandToken1,
    };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static byte Token2(PacketKind kind) => kind switch
    {
        PacketKind.Motion => ProtocolConstants.MotionToken2,
        PacketKind.Calculation => ProtocolConstants.CalculationToken2,
        PacketKind.StudioCalculation => ProtocolConstants.StudioToken2,
        _ => ProtocolConstants.CommandToken2,
    };
}
