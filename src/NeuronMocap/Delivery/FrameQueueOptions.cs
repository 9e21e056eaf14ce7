using NeuronMocap.Delivery;

namespace NeuronMocap;

/// <summary>Options of a queue or of an asynchronous enumeration of frames. The values are copied when it is opened.</summary>
public sealed class FrameQueueOptions
{
    /// <summary>
    /// Largest number of frames that can wait: 1 to 1,048,576, rounded up to a power of two. The default is <see cref="FrameQueue.DefaultCapacity"/>.
    /// </summary>
    public int Capacity { get; set; } = FrameQueue.DefaultCapacity;

    /// <summary>
    /// Name of the queue in metrics and logs. Queues of the same name are counted together. Use few names, and keep them the same. Null, the default, for
    /// "queue", and for "stream" in an enumeration.
    /// </summary>
    public string? Name { get; set; }

    /// <summary>What happens to frames while the queue is full. The default is <see cref="WhenFull.DropNewest"/>.</summary>
    public WhenFull WhenFull { get; set; }

    /// <summary>
    /// Largest number of frames per second for each avatar: 0, or 0.01 to 1000. With 0, the default, the queue gets every frame.
    /// </summary>
    /// <remarks>
    /// The frames that remain are spaced as evenly as possible in the server's time, so an uneven arrival makes no difference. At 120 Hz, 60 gives every
    /// second frame. A rate within 2 % of such a fraction counts as that fraction. A motion frame and a calculation frame of one avatar and the same index
    /// are both added or both skipped.
    /// </remarks>
    public double MaxRate { get; set; }

    /// <summary>
    /// Adds only every n-th frame of each avatar and each kind, beginning with the first: 1 to 1,000,000. The default, 1, is every frame. It excludes
    /// <see cref="MaxRate"/>.
    /// </summary>
    public int EveryNth { get; set; } = 1;

    internal FrameThinning Thinning => new(MaxRate, EveryNth);

    internal FrameQueueOptions Copy(string? defaultName)
    {
        var copy = (FrameQueueOptions)MemberwiseClone();
        copy.Name ??= defaultName;
        return copy;
    }

    internal string? FindFault()
    {
        if (Name is not null && string.IsNullOrWhiteSpace(Name))
            return "Name is empty; set a name, or leave it null.";

        return FindFault(Capacity, WhenFull) ?? Thinning.FindFault();
    }

    internal static string? FindFault(int capacity, WhenFull whenFull)
    {
        if (capacity is < 1 or > FrameQueue.MaxCapacity)
            return $"Capacity is {capacity}; it must be 1 to 1,048,576 frames.";

        return Enum.IsDefined(typeof(WhenFull), whenFull) ? null : $"WhenFull is {whenFull}; it must be DropNewest, DropOldest or Wait.";
    }
}
