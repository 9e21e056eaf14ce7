namespace NeuronMocap.Server.Broadcasting;

/// <summary>Bytes as they were received, in units: packets, lines, or bytes that are neither. Or a part of them.</summary>
/// <remarks>Each unit counts as a frame. Bytes that are neither packets nor lines belong to the motion.</remarks>
/// <param name="hasMotion">Whether the content includes everything except calculation packets.</param>
/// <param name="hasCalculation">Whether the content includes calculation packets.</param>
internal abstract class UnitContent(bool hasMotion, bool hasCalculation) : BroadcastContent
{
    public override int AvatarCount => 1;

    public override int PacketsPerFrame => 1;

    public override bool HasMotion => hasMotion;

    // When the content includes both, all units count as motion.
    public override bool HasCalculation => !hasMotion;

    // The bytes are always a single frame.
    public override int MeasurePacket(ReadOnlySpan<byte> frames, bool isMotion) => frames.Length;

    // Whether the content includes a unit.
    public bool Takes(bool isCalculation) => isCalculation ? hasCalculation : hasMotion;
}
