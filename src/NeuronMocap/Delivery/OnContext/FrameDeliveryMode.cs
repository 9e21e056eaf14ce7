namespace NeuronMocap;

/// <summary>Which frames a <see cref="FrameDelivery"/> delivers.</summary>
public enum FrameDeliveryMode
{
    /// <summary>
    /// Every frame, in order, unless <see cref="FrameDeliveryOptions.MaxRate"/> or <see cref="FrameDeliveryOptions.EveryNth"/> leaves frames out. Frames that
    /// wait for the context are in a bounded queue.
    /// </summary>
    EveryFrame,

    /// <summary>
    /// The newest frame of each avatar. A newer frame replaces a frame that was not delivered yet. Frames of several UDP senders with the same avatar number
    /// replace each other.
    /// </summary>
    Newest,
}
