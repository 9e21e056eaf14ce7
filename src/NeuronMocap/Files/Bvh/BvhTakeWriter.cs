using System.Diagnostics;
using NeuronMocap.Files;
using NeuronMocap.Skeleton;
using NeuronMocap.Timing;

namespace NeuronMocap.Bvh;

/// <summary>
/// Writes the frames of one avatar to a BVH file as they arrive. Not thread-safe.
/// </summary>
/// <remarks>
/// The first frame determines the hierarchy, the rotation order and the displacement. A row holds the values of a frame bit for bit. A frame that
/// does not fit the hierarchy needs another file: see <see cref="Accepts"/>. The caller must separate the frames of different avatars and senders.
/// Writing a frame does not allocate memory.
/// </remarks>
public sealed class BvhTakeWriter : IDisposable
{
    private readonly Stream _stream;
    private readonly BvhTakeOptions _options;
    private readonly FrameTiming _timing = new();

    // Numbers of the repeated rows that the stream may not have accepted yet.
    private readonly Queue<int> _recentRepeats = [];
    private int _repeated;
    private BvhWriter? _writer;
    private ChannelLayout _layout;
    private SkeletonFormat _format;
    private float[] _row = [];
    private long _start;
    private bool _isDisposed;

    /// <summary>Creates a file. Writing begins with the first frame.</summary>
    /// <param name="path">The path of the file. An existing file is replaced.</param>
    /// <param name="options">The options; null for the defaults.</param>
    /// <exception cref="IOException">The file cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">The user does not have permission to write the file.</exception>
    public BvhTakeWriter(string path, BvhTakeOptions? options = null)
        : this(WritableFile.Create(path), options)
    {
    }

    /// <summary>Writes to a stream, from its current position. Writing begins with the first frame.</summary>
    /// <param name="stream">The stream to write. It is closed at the end.</param>
    /// <param name="options">The options; null for the defaults.</param>
    /// <exception cref="ArgumentException">The stream is not seekable, and the options do not contain the frame time.</exception>
    public BvhTakeWriter(Stream stream, BvhTakeOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(stream);
        _stream = stream;
        _options = options?.Copy() ?? new BvhTakeOptions();
        if (!stream.CanSeek && _options.FrameTime is null)
            throw new ArgumentException("FrameTime is required for a stream that is not seekable, because a measured frame time is known only at the end.", nameof(stream));
    }

    /// <summary>Number of rows written, including repeated rows. If the stream has failed, the number of rows that it holds.</summary>
    public int FrameCount => _writer?.FrameCount ?? 0;

    /// <summary>Number of rows that repeat the previous row in place of lost frames.</summary>
    public int RepeatedFrames => _repeated - _recentRepeats.Count(row => row > FrameCount);

    /// <summary>Number of frames that were skipped because a later frame had arrived before them, as is possible with UDP.</summary>
    public int LateFrames { get; private set; }

    /// <summary>Time from one frame to the next, as far as it is known.</summary>
    public BvhFrameTime FrameTime => _options.FrameTime ?? MeasureFrameTime();

    /// <summary>
    /// Whether a frame can become a row of this file. It must hold the 59 bones, in the layout, rotation order and variant of the previous frames.
    /// </summary>
    /// <param name="frame">The frame.</param>
    public bool Accepts(MotionFrame frame)
    {
        ArgumentNullException.ThrowIfNull(frame);
        return frame.HasSkeleton && (_writer is null || (frame.Layout == _layout && frame.Format == _format));
    }

    /// <summary>
    /// Writes a frame as a row. A frame that arrives after a later one is skipped. A gap is handled as <see cref="BvhTakeOptions.GapHandling"/>
    /// specifies.
    /// </summary>
    /// <param name="frame">The frame. It is read only during the call.</param>
    /// <exception cref="InvalidOperationException"><see cref="Accepts"/> is false.</exception>
    /// <exception cref="IOException">The stream fails.</exception>
    public void Write(MotionFrame frame)
    {
        if (!Accepts(frame))
            throw new InvalidOperationException("The layout of the frame differs from that of the file.");

        _writer ??= Begin(frame);
        int rows = _timing.Add(frame.FrameIndex, TimeOf(frame), frame.Origin);
        if (rows == 0)
        {
            LateFrames++;
            return;
        }

        for (int i = 1; i < rows && _options.GapHandling == BvhGapHandling.Repeat; i++)
            Repeat(_writer);

        frame.Values.CopyTo(_row);
        _writer.WriteFrame(_row);
    }

    /// <summary>
    /// Passes all rows to the operating system, and updates the number of rows and the frame time: see <see cref="BvhWriter.Flush"/>.
    /// </summary>
    /// <exception cref="IOException">The stream fails.</exception>
    public void Flush()
    {
        if (_writer is null)
            return;

        PassFrameTime();
        _writer.Flush();
    }

    /// <summary>Completes the file and closes the stream. Further calls have no effect.</summary>
    /// <exception cref="IOException">The stream fails. It is closed nevertheless.</exception>
    public void Dispose()
    {
        if (_isDisposed)
            return;

        _isDisposed = true;
        if (_writer is null)
        {
            _stream.Dispose();
            return;
        }

        PassFrameTime();
        _writer.Dispose();
    }

    private void Repeat(BvhWriter writer)
    {
        writer.WriteFrame(_row);
        _repeated++;
        while (_recentRepeats.TryPeek(out int row) && row <= writer.TakenFrames)
            _recentRepeats.Dequeue();

        _recentRepeats.Enqueue(writer.FrameCount);
    }

    private void PassFrameTime()
    {
        if (_options.FrameTime is null)
            _writer!.FrameTime = MeasureFrameTime();
    }

    private BvhFrameTime MeasureFrameTime() => _timing.Rate is { } rate ? BvhFrameTime.FromFrameRate(rate) : BvhFrameTime.Default;

    // Times of a played file are even to the tick. Rounding from the first frame on keeps them so.
    private TimeSpan TimeOf(MotionFrame frame) =>
        TimeSpan.FromTicks((long)Math.Round((frame.Timestamp - _start) * (TimeSpan.TicksPerSecond / (double)Stopwatch.Frequency)));

    private BvhWriter Begin(MotionFrame frame)
    {
        _start = frame.Timestamp;
        _layout = frame.Layout;
        _format = frame.Format;
        _row = new float[_layout.ValueCount];
        BvhHierarchy hierarchy = BvhBoneHierarchy.Create(_format, _layout, FindBody(frame));
        return new BvhWriter(_stream, hierarchy, _options.FrameTime ?? BvhFrameTime.Default, _options.TextFormat);
    }

    private SkeletonBody? FindBody(MotionFrame frame)
    {
        SkeletonBody? body = _options.Body?.Variant == _format.Variant ? _options.Body : null;
        if (!_layout.HasDisplacement)
            return body;

        Span<BoneTransform> pose = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        frame.CopyLocalTransforms(pose);
        foreach (BoneTransform bone in pose)
        {
            if (!float.IsFinite(bone.Position.X + bone.Position.Y + bone.Position.Z))
                return body;
        }

        return SkeletonBody.FromPose(pose, _format.Variant, body is null ? default : body.EndSites);
    }
}
