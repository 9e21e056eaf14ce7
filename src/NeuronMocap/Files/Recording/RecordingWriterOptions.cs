namespace NeuronMocap.Recording;

/// <summary>Options of a <see cref="RecordingWriter"/>.</summary>
public sealed class RecordingWriterOptions
{
    /// <summary>The start of the recording, to which all times are relative. Null, the default, means now.</summary>
    public DateTimeOffset? StartTime { get; set; }

    /// <summary>Whether blocks are compressed if that makes them smaller. The default is false.</summary>
    public bool Compress { get; set; }

    /// <summary>Whether the stream stays open when the writer is disposed. The default is false.</summary>
    public bool LeaveOpen { get; set; }

    /// <summary>Identifies the recording; all of its files have the same value. Empty, the default, creates a new value.</summary>
    public Guid RecordingId { get; set; }

    /// <summary>Number of this file within the recording, from 1. The default is 1.</summary>
    public int FileNumber { get; set; } = 1;
}
