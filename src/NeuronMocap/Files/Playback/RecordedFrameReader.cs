using System.Diagnostics;
using NeuronMocap.Delivery;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Recording;

/// <summary>
/// Reads the frames of a file one after the other, without a reader and without threads: of a recording, or of a raw dump of a stream's bytes,
/// whichever the file's first bytes say it is. Frames, skipped bytes and losses are those of a <see cref="NeuronReader"/> that receives the same bytes.
/// <para>
/// Not thread-safe. Memory does not grow with the file, but for a raw dump, which is read once when it is opened, by 16 bytes for each packet.
/// </para>
/// </summary>
public sealed class RecordedFrameReader : IDisposable
{
    // Counters take 0 for "never"; times begin one tick later.
    private const long FirstTimestamp = 1;

    private readonly RecordedEventSource _source;
    private readonly StreamCounters _counters = new();
    private readonly PacketCollector _found;
    private readonly RecordedEventParser _parser;
    private readonly FramePool _frames;
    private AvatarFrame? _frame;
    private bool _hasEnded;

    internal RecordedFrameReader(RecordedEventSource source, PlaybackOptions options)
    {
        _source = source;
        _found = new PacketCollector(_counters);
        _parser = new RecordedEventParser(options.MaxValues ?? source.MaxValues, new SenderFilter([]), _found);
        _frames = new FramePool(source.CreateFormat(options.RotationOrder, options.SkeletonVariant), FramePool.OfTakers);
    }

    /// <summary>Name of the file, without its folder.</summary>
    public string FileName => _source.FileName;

    /// <summary>
    /// How long the stream was recorded; of a raw dump, how long its frames take at their rate.
    /// </summary>
    public TimeSpan Duration => _source.Duration;

    /// <summary>
    /// The frame that <see cref="Read"/> found: a <see cref="MotionFrame"/>, a <see cref="CalculationFrame"/> or a
    /// <see cref="StudioCalculationFrame"/>. Valid until the next call, after which its members throw; <c>Clone</c> makes one to keep. Its <see cref="AvatarFrame.Timestamp"/> counts from
    /// the start of the file, its age has no meaning.
    /// </summary>
    /// <exception cref="InvalidOperationException">There is none: nothing was read, or the end was.</exception>
    public AvatarFrame Frame => _frame ?? throw new InvalidOperationException("No frame is available: Read was not called, or it reached the end.");

    /// <summary>When the bytes that completed the frame arrived, since the recording's start.</summary>
    public TimeSpan Time { get; private set; }

    /// <summary>Number of the connection that the frame came over, from 0.</summary>
    public int Connection { get; private set; }

    /// <summary>
    /// What was read so far, as a <see cref="NeuronReader"/> would have it of the same bytes. All that the file holds, once <see cref="Read"/> was false.
    /// </summary>
    /// <returns>A snapshot.</returns>
    public ReaderStatistics GetStatistics() => _counters.Snapshot();

    /// <summary>What was read so far of each avatar, in the order in which they appeared; at most 1024.</summary>
    /// <returns>A snapshot.</returns>
    public IReadOnlyList<AvatarStatistics> GetAvatarStatistics() => [.. _counters.Trackers.Select(static tracker => tracker.Snapshot)];

    /// <summary>Skipped bytes of one reason.</summary>
    /// <param name="reason">Why they were skipped.</param>
    /// <returns>Bytes so far.</returns>
    public long GetSkipped(SkipReason reason) => _counters.GetSkipped(reason);

    // Of a raw dump, whose times are made of it; null where times were recorded.
    internal double? EvenRate => (_source as RawDumpSource)?.FrameRate;

    /// <summary>Opens a file.</summary>
    /// <param name="path">A recording (<c>.nmrec</c>), or the bytes of a stream as they came off the wire. Which one it is, its first bytes tell, not its name.</param>
    /// <param name="options">How to read it; null for what the file says.</param>
    /// <returns>A reader that stands before the first frame.</returns>
    /// <exception cref="PlaybackException">The file is neither.</exception>
    /// <exception cref="NeuronException">It is a recording that cannot be read.</exception>
    /// <exception cref="IOException">The file cannot be opened or read.</exception>
    /// <exception cref="UnauthorizedAccessException">The file may not be read.</exception>
    /// <exception cref="ArgumentException">An option is out of its range, or has no meaning for this file.</exception>
    public static RecordedFrameReader Open(string path, PlaybackOptions? options = null)
    {
        PlaybackOptions copy = PlaybackOptions.CopyChecked(options);
        return new RecordedFrameReader(RecordedEventSource.Open(path, copy), copy);
    }

    /// <summary>Goes on to the next frame.</summary>
    /// <returns>False when there is none.</returns>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public bool Read()
    {
        _frame?.Expire();
        _frame = null;
        ReceivedPacket packet;
        while (!_found.TryTake(out packet))
        {
            if (_hasEnded)
                return false;

            RecordedEvent recorded = _source.Read();
            Time = recorded.Time;
            if (recorded.Kind == RecordedEventKind.End)
            {
                // What waited to be told whose it is comes out now.
                _hasEnded = true;
                _parser.Close(recorded.Time);
                continue;
            }

            if (_parser.Follow(recorded, FirstTimestamp + (long)(recorded.Time.TotalSeconds * Stopwatch.Frequency)))
                _counters.Resume(recorded.IsCalculation);

            Connection = _parser.Connection;
        }

        _frame = _frames.Lend(packet);
        return true;
    }

    /// <summary>Closes the file.</summary>
    public void Dispose() => _source.Dispose();
}
