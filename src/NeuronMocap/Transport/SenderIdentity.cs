namespace NeuronMocap.Transport;

// What a sender's first header tells of it. The kind is None where text has begun that does not tell yet.
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

    // Whether both are of one body, as far as their first frames tell.
    public bool IsOfSameAvatar(in SenderIdentity other) => Avatar == other.Avatar && Name == other.Name;
}
