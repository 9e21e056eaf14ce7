using NeuronMocap.Recording;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>A recording as it was received, or a part of it.</summary>
/// <remarks>
/// Each unit counts as a frame. A unit is a packet, a line, or bytes that are neither. Bytes that are neither belong to the motion.
/// </remarks>
internal sealed class RecordingContent : BroadcastContent
{
    private readonly string _path;
    private readonly bool _isLooped;
    private readonly PlaybackOptions _options;

    /// <summary>Opens the recording once to check that it can be played.</summary>
    /// <param name="options">The settings, with the recording.</param>
    /// <param name="hasMotion">Whether the content includes everything except calculation packets.</param>
    /// <param name="hasCalculation">Whether the content includes calculation packets.</param>
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

    // When the content includes both, all units count as motion.
    public override bool HasCalculation => !HasMotion;

    public bool TakesCalculation { get; }

    public override int MaxFrameSize { get; }

    // The bytes are always a single frame.
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
