using NeuronMocap.Delivery;
using NeuronMocap.Frames;
using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Recording;

/// <summary>
/// Reads the frames of a recording or a raw dump one after the other, without a <see cref="NeuronReader"/> and without threads. Not thread-safe.
/// </summary>
/// <remarks>
/// <para>
/// The first bytes of the file determine its kind. Frames, skipped bytes and losses are those of a <see cref="NeuronReader"/> that receives the
/// same bytes.
/// </para>
/// <para>
/// The memory does not grow with a recording. A raw dump is read once when it is opened and needs 16 bytes for each packet.
/// </para>
/// </remarks>
public sealed class RecordedFrameReader : IDisposable
{
    // Counters use 0 for "never". Times therefore begin at one tick.
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
    /// Duration of the recorded stream. For a raw dump, the duration of its frames at their rate.
    /// </summary>
    public TimeSpan Duration => _source.Duration;

    /// <summary>
    /// The frame that <see cref="Read"/> found: a <see cref="MotionFrame"/>, a <see cref="CalculationFrame"/> or a
    /// <see cref="StudioCalculationFrame"/>.
    /// </summary>
    /// <remarks>
    /// The frame is valid until the next call; after that, its members throw. Use <c>Clone</c> to keep it. Its <see cref="AvatarFrame.Timestamp"/>
    /// is relative to the start of the file, and its age has no meaning.
    /// </remarks>
    /// <exception cref="InvalidOperationException">There is no frame, because <see cref="Read"/> was not called or reached the end.</exception>
    public AvatarFrame Frame => _frame ?? throw new InvalidOperationException("No frame is available: Read was not called, or it reached the end.");

    /// <summary>The receive time of the bytes that completed the frame, since the start of the recording.</summary>
    public TimeSpan Time { get; private set; }

    /// <summary>Number of the frame's connection, from 0.</summary>
    public int Connection { get; private set; }

    /// <summary>
    /// Gets the statistics of the data read so far. They equal those of a <see cref="NeuronReader"/> that receives the same bytes. After
    /// <see cref="Read"/> returns false, they cover the whole file.
    /// </summary>
    /// <returns>A snapshot.</returns>
    public ReaderStatistics GetStatistics() => _counters.Snapshot();

    /// <summary>Gets the statistics of each avatar in the data read so far, in order of appearance; at most 1024.</summary>
    /// <returns>A snapshot.</returns>
    public IReadOnlyList<AvatarStatistics> GetAvatarStatistics() => [.. _counters.Trackers.Select(static tracker => tracker.Snapshot)];

    /// <summary>Gets the number of bytes skipped for one reason.</summary>
    /// <param name="reason">The reason.</param>
    /// <returns>The number of bytes so far.</returns>
    public long GetSkipped(SkipReason reason) => _counters.GetSkipped(reason);

    // The rate of a raw dump, from which its times are computed; null if times were recorded.
    internal double? EvenRate => (_source as RawDumpSource)?.FrameRate;

    /// <summary>Opens a file.</summary>
    /// <param name="path">
    /// The path of a recording (<c>.nmrec</c>), or of the received bytes of a stream. The first bytes determine the kind of the file, not its name.
    /// </param>
    /// <param name="options">The options; null to use the values of the file.</param>
    /// <returns>A reader before the first frame.</returns>
    /// <exception cref="PlaybackException">The file is neither a recording nor a dump of a stream.</exception>
    /// <exception cref="NeuronException">The file is a recording that cannot be read.</exception>
    /// <exception cref="IOException">The file cannot be opened or read, or is a pipe.</exception>
    /// <exception cref="UnauthorizedAccessException">The user does not have permission to read the file.</exception>
    /// <exception cref="ArgumentException">An option is out of range, or has no meaning for this file.</exception>
    public static RecordedFrameReader Open(string path, PlaybackOptions? options = null)
    {
        PlaybackOptions copy = PlaybackOptions.CopyChecked(options);
        return new RecordedFrameReader(RecordedEventSource.Open(path, copy), copy);
    }

    /// <summary>Reads the next frame.</summary>
    /// <returns>True if a frame was read; false at the end.</returns>
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
                // Datagrams that wait for their sender to be identified are processed now.
                _hasEnded = true;
                _parser.Close(recorded.Time);
                continue;
            }

            if (_parser.Follow(recorded, FirstTimestamp + RecordedTime.ToTimestamp(recorded.Time)))
                _counters.Resume(recorded.IsCalculation);

            Connection = _parser.Connection;
        }

        _frame = _frames.Lend(packet);
        return true;
    }

    /// <summary>Closes the file.</summary>
    public void Dispose() => _source.Dispose();
}
