namespace NeuronMocap.Protocol;

// The pair of tokens that frames every header: two bytes at offset 0, two at offset 62.
internal static class PacketTokens
{
    public static PacketKind KindOf(byte token1) => token1 switch
    {
        ProtocolConstants.MotionToken1 => PacketKind.Motion,
        ProtocolConstants.CalculationToken1 => PacketKind.Calculation,
        ProtocolConstants.CommandToken1 => PacketKind.Command,
        _ => PacketKind.None,
    };

    // The caller has seen 64 bytes.
    public static PacketKind KindOf(ReadOnlySpan<byte> header)
    {
        PacketKind kind = header[0] == ProtocolConstants.TokenStart ? KindOf(header[1]) : PacketKind.None;
        return kind != PacketKind.None && HasToken2(header, kind) ? kind : PacketKind.None;
    }

    public static bool Match(ReadOnlySpan<byte> source, PacketKind kind) =>
        source.Length >= ProtocolConstants.HeaderSize && KindOf(source) == kind;

    public static bool HasToken2(ReadOnlySpan<byte> header, PacketKind kind) =>
        header[ProtocolConstants.Token2Offset] == ProtocolConstants.TokenStart
        && header[ProtocolConstants.Token2Offset + 1] == Token2(kind);

    public static void Write(Span<byte> header, PacketKind kind)
    {
        header[0] = ProtocolConstants.TokenStart;
        header[1] = Token1(kind);
        header[ProtocolConstants.Token2Offset] = ProtocolConstants.TokenStart;
        header[ProtocolConstants.Token2Offset + 1] = Token2(kind);
    }

    private static byte Token1(PacketKind kind) => kind switch
    {
        PacketKind.Motion => ProtocolConstants.MotionToken1,
        PacketKind.Calculation => ProtocolConstants.CalculationToken1,
        _ => ProtocolConstants.CommandToken1,
    };

    private static byte Token2(PacketKind kind) => kind switch
    {
        PacketKind.Motion => ProtocolConstants.MotionToken2,
        PacketKind.Calculation => ProtocolConstants.CalculationToken2,
        _ => ProtocolConstants.CommandToken2,
    };
}
