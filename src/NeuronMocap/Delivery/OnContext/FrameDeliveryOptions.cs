using NeuronMocap.Delivery;

namespace NeuronMocap;

/// <summary>Options of <see cref="NeuronReader.OpenDelivery"/>. The values are copied when the delivery is opened.</summary>
public sealed class FrameDeliveryOptions
{
    internal const string DefaultName = "delivery";

    /// <summary>
    /// The context on which handlers run. Null, the default, means the <see cref="SynchronizationContext.Current"/> of the thread that opens the delivery.
    /// </summary>
    public SynchronizationContext? Context { get; set; }

    /// <summary>
    /// A function that posts an action to the window's thread, instead of <see cref="Context"/>. It must return without running the action and without
    /// waiting. It returns false, or throws, if the window is gone; the delivery then ends. Null, the default, for none.
    /// </summary>
    /// <remarks>
    /// The function must be thread-safe. It is called on the receive thread, on the window's thread, and on pool threads; calls can overlap. It gets the
    /// same <see cref="Action"/> each time.
    /// </remarks>
    public Func<Action, bool>? Post { get; set; }

    /// <summary>Which frames are delivered. The default is <see cref="FrameDeliveryMode.EveryFrame"/>.</summary>
    public FrameDeliveryMode Mode { get; set; }

    /// <summary>
    /// The largest number of frames per second for each avatar, on average: 0, or 0.01 to 1000. With 0, the default, frames are delivered as fast as they
    /// arrive and the context runs.
    /// </summary>
    /// <remarks>
    /// With <see cref="FrameDeliveryMode.EveryFrame"/>, frames in between are skipped as they arrive: see <see cref="FrameQueueOptions.MaxRate"/>. With
    /// <see cref="FrameDeliveryMode.Newest"/>, they are replaced while they wait, so a stream that stops ends with its newest frame.
    /// </remarks>
    public double MaxRate { get; set; }

    /// <summary>
    /// With <see cref="FrameDeliveryMode.EveryFrame"/>, delivers only every n-th frame of each avatar and each kind: 1 to 1,000,000. The default, 1, is
    /// every frame. It excludes <see cref="MaxRate"/>.
    /// </summary>
    public int EveryNth { get; set; } = 1;

    /// <summary>
    /// With <see cref="FrameDeliveryMode.EveryFrame"/>, what happens to frames while the queue is full. The default is <see cref="WhenFull.DropNewest"/>.
    /// </summary>
    /// <remarks>
    /// With <see cref="WhenFull.Wait"/>, a busy window holds up the receive thread and all consumers of the reader. The wait ends when the delivery or the
    /// reader is disposed, and when the window is gone.
    /// </remarks>
    public WhenFull WhenFull { get; set; }

    /// <summary>
    /// With <see cref="FrameDeliveryMode.EveryFrame"/>, the largest number of frames that can wait: 1 to 1,048,576, rounded up to a power of two. The
    /// default is <see cref="FrameQueue.DefaultCapacity"/>.
    /// </summary>
    public int Capacity { get; set; } = FrameQueue.DefaultCapacity;

    /// <summary>
    /// Name of the delivery in metrics and logs. Queues, and deliveries of every frame, of the same name are counted together. Use few names, and keep them the same. The
    /// default is "delivery".
    /// </summary>
    public string Name { get; set; } = DefaultName;

    internal FrameThinning Thinning => new(MaxRate, EveryNth);

    internal FrameDeliveryOptions Copy() => (FrameDeliveryOptions)MemberwiseClone();

    internal string? FindFault()
    {
        if (Context is not null && Post is not null)
            return "Context and Post are both set; set one of them.";
        if (!Enum.IsDefined(typeof(FrameDeliveryMode), Mode))
            return $"Mode is {Mode}; it must be EveryFrame or Newest.";
        if ((Thinning.FindFault() ?? FrameQueueOptions.FindFault(Capacity, WhenFull)) is { } fault)
            return fault;
        if (EveryNth > 1 && Mode == FrameDeliveryMode.Newest)
            return "EveryNth requires the mode EveryFrame; set MaxRate for Newest.";
        if (WhenFull != WhenFull.DropNewest && Mode == FrameDeliveryMode.Newest)
            return "WhenFull requires the mode EveryFrame; Newest has no queue.";

        return string.IsNullOrWhiteSpace(Name) ? "Name is empty; set a name." : null;
    }
}
