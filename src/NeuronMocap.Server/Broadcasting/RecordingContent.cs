using NeuronMocap.Recording;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>
/// A recording as it was received, or a part of it. What counts as a frame is a unit: a packet or a line, or bytes that are neither, which go with the motion.
/// </summary>
internal sealed class RecordingContent : BroadcastContent
{
    private readonly string _path;
    private readonly bool _isLooped;
    private readonly PlaybackOptions _options;

    /// <summary>Opens the recording once, to see whether it can be played.</summary>
    /// <param name="options">Which recording.</param>
    /// <param name="hasMotion">Whether what is not calculation belongs to it.</param>
    /// <param name="hasCalculation">Whether calculation packets do.</param>
    public RecordingContent(BroadcasterOptions options, bool hasMotion, bool hasCalculation)
    {
        HasMotion = hasMotion;
        TakesCalculation = hasCalculation;
        _path = options.RecordingPath!;
        _isLooped = options.LoopRecording;
        _options = new PlaybackOptions { FrameRate = options.FrameRate is { } rate && !double.IsPositiveInfinity(rate) ? rate : null };
        using RecordedEventSource source = Open();
        MaxFrameSize = RecordedUnits.LongestUnit(source.MaxValues);
    }

    public override int AvatarCount => 1;

    public override int PacketsPerFrame => 1;

    public override bool HasMotion { get; }

    // Where both are in it, nothing tells them apart.
    public override bool HasCalculation => !HasMotion;

    public bool TakesCalculation { get; }

    public override int MaxFrameSize { get; }

    // A single frame is what there is.
    public override int MeasurePacket(ReadOnlySpan<byte> frames, bool isMotion) => frames.Length;

    public override FrameFeed CreateFeed(bool isSingle) => new RecordingFeed(this, _isLooped, isSingle);

    public RecordedUnits OpenUnits() => new(Open());

    public bool Takes(RecordedUnits units) => units.IsCalculation ? TakesCalculation : HasMotion;

    private RecordedEventSource Open()
    {
        try
        {
            return RecordedEventSource.Open(_path, _options);
        }
        catch (ArgumentException) when (_options.FrameRate is not null)
        {
            throw BroadcasterOptionsCheck.Fault(
                nameof(BroadcasterOptions.FrameRate), "must be null or MaxFrameRate: a recording has its own times; set RecordingSpeed instead", _options.FrameRate);
        }
    }
}
