namespace NeuronMocap.Recording;

/// <summary>Options of <see cref="NeuronReader.StartRecording"/>. The values are copied when the recording starts.</summary>
public sealed class RecordingOptions
{
    private const int SmallestQueue = 1024 * 1024;
    private const int LargestQueue = 1024 * 1024 * 1024;
    private const long SmallestFile = 1024 * 1024;
    private static readonly TimeSpan ShortestFile = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan LongestFile = TimeSpan.FromDays(3650);

    /// <summary>Whether an existing file is overwritten. The default is false: an existing file is an error.</summary>
    public bool Overwrite { get; set; }

    /// <summary>
    /// Whether the file is compressed. The default is false. Compression takes the recording's own thread about 20 ms for each megabyte.
    /// </summary>
    public bool Compress { get; set; }

    /// <summary>
    /// Number of bytes that can wait to be written, 1 MiB to 1 GiB, rounded up to a power of two. The memory is allocated at the start. The default
    /// is 8 MiB: 45 s of one avatar at 120 Hz. While the queue is full, received bytes are missing from the recording and counted there.
    /// </summary>
    public int QueueSize { get; set; } = 8 * 1024 * 1024;

    /// <summary>
    /// Maximum time that bytes wait before they are passed to the operating system, 0.01 s to one minute. The default is 0.25 s. If the process is
    /// killed, at most this much of the recording is lost.
    /// </summary>
    public TimeSpan FlushInterval { get; set; } = TimeSpan.FromSeconds(0.25);

    /// <summary>
    /// Whether the operating system also writes to the disk at each <see cref="FlushInterval"/>. A power failure then costs no more than a killed
    /// process. The default is false.
    /// </summary>
    public bool FlushToDisk { get; set; }

    /// <summary>
    /// Maximum size of a file in bytes, 1 MiB or more. Null, the default, means no limit. At the limit, the next file begins, which can be read
    /// independently. A single larger piece has its own file.
    /// </summary>
    public long? MaxFileSize { get; set; }

    /// <summary>
    /// Maximum duration of a file, one second to ten years. Null, the default, means no limit. The first data after this time begins the next file.
    /// </summary>
    public TimeSpan? MaxFileDuration { get; set; }

    /// <summary>
    /// Maximum number of files to keep, 1 or more. Null, the default, means no limit. When a file begins, the oldest one is deleted; if that fails,
    /// the next file triggers another attempt. Requires <see cref="MaxFileSize"/> or <see cref="MaxFileDuration"/>.
    /// </summary>
    public int? MaxFiles { get; set; }

    internal bool HasNumbers => MaxFileSize is not null || MaxFileDuration is not null;

    internal RecordingOptions Copy() => (RecordingOptions)MemberwiseClone();

    internal string? FindFault()
    {
        if (QueueSize is < SmallestQueue or > LargestQueue)
            return $"QueueSize is {QueueSize}; it must be 1,048,576 to 1,073,741,824.";
        if (FlushInterval < TimeSpan.FromSeconds(0.01) || FlushInterval > TimeSpan.FromMinutes(1))
            return $"FlushInterval is {FlushInterval}; it must be 0.01 s to 1 minute.";
        if (MaxFileSize < SmallestFile)
            return $"MaxFileSize is {MaxFileSize}; it must be 1,048,576 or more, or null.";
        if (MaxFileDuration < ShortestFile || MaxFileDuration > LongestFile)
            return $"MaxFileDuration is {MaxFileDuration}; it must be 1 s to 3650 days, or null.";
        if (MaxFiles < 1)
            return $"MaxFiles is {MaxFiles}; it must be 1 or more, or null.";

        return MaxFiles is not null && !HasNumbers ? "MaxFiles requires MaxFileSize or MaxFileDuration; without them, there is only one file." : null;
    }
}
