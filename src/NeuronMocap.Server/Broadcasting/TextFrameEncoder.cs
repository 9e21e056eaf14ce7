using NeuronMocap.Protocol;
using NeuronMocap.Server.Faults;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>Encodes the lines of the text stream (protocol.md section 8).</summary>
internal sealed class TextFrameEncoder(FramePlan plan) : FrameEncoder(plan)
{
    private readonly bool _lineFeedOnly = plan.TextQuirks.HasFlag(TextQuirks.LineFeedOnly);
    private readonly bool _strayZeros = plan.TextQuirks.HasFlag(TextQuirks.StrayZeros);

    // One more byte for a stray zero.
    public static int MaxMotionSize(FramePlan plan) => 1 + TextEncoder.GetMaxMotionSize(plan.Layout.ValueCount, plan.TextDecimals);

    public static int MaxCalculationSize(FramePlan plan) => 1 + TextEncoder.GetMaxCalculationSize(plan.CalculationValueCount, plan.TextDecimals);

    protected override int WriteMotion(long frame, int avatar, Span<byte> destination)
    {
        int start = BeginLine(destination);
        int end = start + TextEncoder.WriteMotion(destination[start..], avatar, Plan.Names[avatar], GetMotion(frame, avatar), Plan.TextDecimals);
        if (_lineFeedOnly)
            destination[--end - 1] = (byte)'\n';

        return end;
    }

    protected override int WriteCalculation(long frame, int avatar, Span<byte> destination)
    {
        int start = BeginLine(destination);
        return start + TextEncoder.WriteCalculation(destination[start..], Calculate(frame, avatar), Plan.TextDecimals);
    }

    private int BeginLine(Span<byte> destination)
    {
        if (!_strayZeros)
            return 0;

        destination[0] = 0;
        return 1;
    }
}
