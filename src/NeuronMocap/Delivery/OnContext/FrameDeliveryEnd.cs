namespace NeuronMocap;

/// <summary>Why a <see cref="FrameDelivery"/> has ended.</summary>
/// <param name="Reason">The reason.</param>
/// <param name="Message">One or two English sentences for people.</param>
/// <param name="Exception">The exception that the context threw when the delivery posted to it; null if there was none.</param>
public sealed record FrameDeliveryEnd(FrameDeliveryEndReason Reason, string Message, Exception? Exception = null);
