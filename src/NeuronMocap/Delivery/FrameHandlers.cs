namespace NeuronMocap.Delivery;

// Who takes the frames of a queue. Structs, so that a call costs no more than its delegate and allocates nothing.
internal interface IFrameHandlers
{
    void OnMotion(MotionFrame frame);

    void OnCalculation(CalculationFrame frame);

    void OnStudioCalculation(StudioCalculationFrame frame);
}

internal readonly struct FrameHandlers(
    Action<MotionFrame>? onMotion, Action<CalculationFrame>? onCalculation, Action<StudioCalculationFrame>? onStudioCalculation) : IFrameHandlers
{
    public void OnMotion(MotionFrame frame) => onMotion?.Invoke(frame);

    public void OnCalculation(CalculationFrame frame) => onCalculation?.Invoke(frame);

    public void OnStudioCalculation(StudioCalculationFrame frame) => onStudioCalculation?.Invoke(frame);
}

internal readonly struct FrameHandlers<TState>(
    TState state,
    Action<TState, MotionFrame>? onMotion,
    Action<TState, CalculationFrame>? onCalculation,
    Action<TState, StudioCalculationFrame>? onStudioCalculation) : IFrameHandlers
{
    public void OnMotion(MotionFrame frame) => onMotion?.Invoke(state, frame);

    public void OnCalculation(CalculationFrame frame) => onCalculation?.Invoke(state, frame);

    public void OnStudioCalculation(StudioCalculationFrame frame) => onStudioCalculation?.Invoke(state, frame);
}
