namespace NeuronMocap.Recording;

/// <summary>How a <see cref="RecordingWriter"/> writes.</summary>
public sealed class RecordingWriterOptions
{
    /// <summary>The moment that all times count from. Null, the default, for now.</summary>
    public DateTimeOffset? StartTime { get; set; }

    /// <summary>Whether blocks are compressed where that makes them smaller. Default: false.</summary>
    public bool Compress { get; set; }

    /// <summary>Whether the stream stays open when the writer is disposed of. Default: false.</summary>
    public bool LeaveOpen { get; set; }

    /// <summary>What the files of one recording have in common. Empty, the default, for a new one.</summary>
    public Guid RecordingId { get; set; }

    /// <summary>Which file of the recording this is, from 1. Default: 1.</summary>
    public int FileNumber { get; set; } = 1;
}
