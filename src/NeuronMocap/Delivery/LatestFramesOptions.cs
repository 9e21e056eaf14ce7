using NeuronMocap.Delivery;

namespace NeuronMocap;

/// <summary>Options of <see cref="NeuronReader.OpenLatest"/>. The values are copied when the view is opened.</summary>
public sealed class LatestFramesOptions
{
    /// <summary>
    /// Largest number of frames per second for each avatar: 0, or 0.01 to 1000. With 0, the default, the view gets every frame. See
    /// <see cref="FrameQueueOptions.MaxRate"/>.
    /// </summary>
    /// <remarks>If the stream stops, the view keeps the last frame that was due, which may not be the last frame of the stream.</remarks>
    public double MaxRate { get; set; }

    /// <summary>
    /// Shows only every n-th frame of each avatar and each kind, beginning with the first: 1 to 1,000,000. The default, 1, is every frame. It excludes
    /// <see cref="MaxRate"/>.
    /// </summary>
    public int EveryNth { get; set; } = 1;

    internal FrameThinning Thinning => new(MaxRate, EveryNth);
}
