namespace NeuronMocap.Recording;

/// <summary>How <see cref="NeuronReader.StartRecording"/> records. The recording takes a copy when it starts.</summary>
public sealed class RecordingOptions
{
    private const int SmallestQueue = 1024 * 1024;
    private const int LargestQueue = 1024 * 1024 * 1024;
    private const long SmallestFile = 1024 * 1024;
    private static readonly TimeSpan ShortestFile = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan LongestFile = TimeSpan.FromDays(3650);

    /// <summary>Whether an existing file is overwritten. Off unless set: then it is an error.</summary>
    public bool Overwrite { get; set; }

    /// <summary>Whether the file is compressed. Off unless set. It costs the recording's own thread about 20 ms for each megabyte.</summary>
    public bool Compress { get; set; }

    /// <summary>
    /// Bytes that can wait to be written, 1 MiB to 1 GiB, rounded up to a power of two and allocated when the recording starts. 8 MiB unless set: 45 s
    /// of one avatar at 120 Hz. What arrives while it is full is missing in the recording, and counted there.
    /// </summary>
    public int QueueSize { get; set; } = 8 * 1024 * 1024;

    /// <summary>
    /// How long bytes may wait until they are handed to the system, 0.01 s to a minute; 0.25 s unless set. So much may be missing when the process
    /// is killed.
    /// </summary>
    public TimeSpan FlushInterval { get; set; } = TimeSpan.FromSeconds(0.25);

    /// <summary>
    /// Whether the system is made to write to the disk, too, at each <see cref="FlushInterval"/>, so that a failure of the power costs no more than the
    /// end of the process does. Off unless set.
    /// </summary>
    public bool FlushToDisk { get; set; }

    /// <summary>
    /// Most bytes of a file, 1 MiB or more; null, the default, for no limit. Where it is reached, the next file begins, which is whole by itself. A
    /// single piece that is larger gets a file of its own.
    /// </summary>
    public long? MaxFileSize { get; set; }

    /// <summary>Longest time that a file covers, a second to ten years; null, the default, for no limit. Where it is reached and something arrives, the next file begins.</summary>
    public TimeSpan? MaxFileDuration { get; set; }

    /// <summary>
    /// Most files that are kept, 1 or more; null, the default, for no limit. When another begins, the recording's oldest is deleted; one that
    /// cannot be deleted is tried again with the next. Needs <see cref="MaxFileSize"/> or <see cref="MaxFileDuration"/>.
    /// </summary>
    public int? MaxFiles { get; set; }

    internal bool HasNumbers => MaxFileSize is not null || MaxFileDuration is not null;

    internal RecordingOptions Copy() => (RecordingOptions)MemberwiseClone();

    internal string? FindFault()
    {
        if (QueueSize is < SmallestQueue or > LargestQueue)
            return $"QueueSize is {QueueSize}; it must be 1,048,576 to 1,073,741,824.";
        if (FlushInterval < TimeSpan.FromSeconds(0.01) || FlushInterval > TimeSpan.FromMinutes(1))
            return $"FlushInterval is {FlushInterval}; it must be 0.01 s to a minute.";
        if (MaxFileSize < SmallestFile)
            return $"MaxFileSize is {MaxFileSize}; it must be 1,048,576 or more, or null.";
        if (MaxFileDuration < ShortestFile || MaxFileDuration > LongestFile)
            return $"MaxFileDuration is {MaxFileDuration}; it must be 1 s to 3650 days, or null.";
        if (MaxFiles < 1)
            return $"MaxFiles is {MaxFiles}; it must be 1 or more, or null.";

        return MaxFiles is not null && !HasNumbers ? "MaxFiles needs MaxFileSize or MaxFileDuration: there is only one file without." : null;
    }
}
