namespace NeuronMocap.Server.Broadcasting;

/// <summary>What a reader receives from now on, or a part of it.</summary>
/// <param name="reader">The reader.</param>
/// <param name="hasMotion">Whether the content includes everything except calculation packets.</param>
/// <param name="hasCalculation">Whether the content includes calculation packets.</param>
internal sealed class ReaderContent(NeuronReader reader, bool hasMotion, bool hasCalculation) : UnitContent(hasMotion, hasCalculation)
{
    public override int MaxFrameSize { get; } = UnitParser.LongestUnit(reader.MaxValues);

    // All recipients read from the log.
    public override FrameFeed CreateFeed(bool isSingle) => throw new InvalidOperationException("A stream that still arrives has no whole.");
}
