using NeuronMocap.Recording;

namespace NeuronMocap.Server.Broadcasting;

/// <summary>A recording as it was received, or a part of it.</summary>
internal sealed class RecordingContent : UnitContent
{
    private readonly string _path;
    private readonly bool _isLooped;
    private readonly PlaybackOptions _options;

    /// <summary>Opens the recording once to check that it can be played.</summary>
    /// <param name="options">The settings, with the recording.</param>
    /// <param name="hasMotion">Whether the content includes everything except calculation packets.</param>
    /// <param name="hasCalculation">Whether the content includes calculation packets.</param>
    public RecordingContent(BroadcasterOptions options, bool hasMotion, bool hasCalculation)
        : base(hasMotion, hasCalculation)
    {
        _path = options.RecordingPath!;
        _isLooped = options.LoopRecording;
        _options = new PlaybackOptions { FrameRate = options.FrameRate is { } rate && !double.IsPositiveInfinity(rate) ? rate : null };
        using RecordedEventSource source = Open();
        MaxFrameSize = UnitParser.LongestUnit(source.MaxValues);
    }

    public override int MaxFrameSize { get; }

    public override FrameFeed CreateFeed(bool isSingle) => new RecordingFeed(this, _isLooped, isSingle);

    public RecordedUnits OpenUnits() => new(Open());

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
