namespace NeuronMocap.Server.Broadcasting;

/// <summary>Writes the packets of a frame. The same frame number always gives the same bytes.</summary>
/// <remarks>Allocates nothing per frame. An encoder has scratch memory, so each thread needs its own.</remarks>
internal abstract class FrameEncoder(FramePlan plan)
{
    private readonly float[] _motion = new float[plan.WritesInPlace ? 0 : plan.Layout.ValueCount];
    private readonly float[] _calculation = new float[plan.Calculation is null ? 0 : CalculationFrame.FullValueCount];

    protected FramePlan Plan => plan;

    /// <summary>Writes a frame of all avatars.</summary>
    /// <param name="frame">Number of the frame.</param>
    /// <param name="destination">Room for <see cref="FramePlan.MaxFrameSize"/> bytes.</param>
    /// <returns>Number of bytes written.</returns>
    public int Encode(long frame, Span<byte> destination)
    {
        int written = 0;
        for (int avatar = 0; avatar < plan.AvatarCount; avatar++)
        {
            if (plan.HasMotion)
                written += WriteMotion(frame, avatar, destination[written..]);
            if (plan.HasCalculation)
                written += WriteCalculation(frame, avatar, destination[written..]);
        }

        return written;
    }

    protected abstract int WriteMotion(long frame, int avatar, Span<byte> destination);

    protected abstract int WriteCalculation(long frame, int avatar, Span<byte> destination);

    // The values are valid until the next call.
    protected ReadOnlySpan<float> GetMotion(long frame, int avatar)
    {
        plan.Sources[avatar].WriteValues(frame, plan.Layout, plan.Order, _motion);
        return _motion;
    }

    // Returns as many values as the broadcast carries. They are valid until the next call.
    protected ReadOnlySpan<float> Calculate(long frame, int avatar)
    {
        plan.Calculation!(plan.Sources[avatar], frame, _calculation);
        return _calculation.AsSpan(0, plan.CalculationValueCount);
    }
}
