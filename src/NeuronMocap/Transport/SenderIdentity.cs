namespace NeuronMocap.Transport;

// The identity of a sender, from its first header. The kind is None if only the start of a text line has arrived, which does not show the kind.
internal readonly record struct SenderIdentity(PacketKind Kind, uint Avatar, AvatarName Name)
{
    public bool IsCalculation => Kind is PacketKind.Calculation or PacketKind.StudioCalculation;

    public static SenderIdentity Read(PacketKind kind, ReadOnlySpan<byte> header) => kind switch
    {
        PacketKind.Motion => new(kind, MotionHeader.ReadAvatarIndex(header), MotionHeader.ReadAvatarName(header)),
        PacketKind.Calculation or PacketKind.StudioCalculation =>
            new(kind, CalculationHeader.ReadAvatarIndex(header), CalculationHeader.ReadAvatarName(header)),
        _ => new(kind, 0, default),
    };

    // Whether both belong to the same body, according to their first frames.
    public bool IsOfSameAvatar(in SenderIdentity other) => Avatar == other.Avatar && Name == other.Name;
}
