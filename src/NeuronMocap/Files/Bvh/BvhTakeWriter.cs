using NeuronMocap.Files;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Bvh;

/// <summary>
/// Makes a BVH file of the frames of one avatar, as they come. Hierarchy, rotation order and displacement are those of the first frame; a row holds
/// a frame's values bit for bit. A frame that the hierarchy does not fit needs another file: <see cref="Accepts"/>. Frames of several
/// avatars or senders have to be told apart by the caller. A frame allocates nothing. For one thread.
/// </summary>
public sealed class BvhTakeWriter : IDisposable
{
    private readonly Stream _stream;
    private readonly BvhTakeOptions _options;
    private readonly FrameSequence _sequence;

    // Numbers of the rows that stand in for others, as far as the stream may not have taken them.
    private readonly Queue<int> _recentRepeats = [];
    private int _repeated;
    private BvhWriter? _writer;
    private ChannelLayout _layout;
    private SkeletonFormat _format;
    private float[] _row = [];
    private int _origin;
    private bool _isDisposed;

    /// <summary>Opens a file. Nothing is written before the first frame.</summary>
    /// <param name="path">Where; a file that is there already is replaced.</param>
    /// <param name="options">What the frames do not say; null for the defaults.</param>
    /// <exception cref="IOException">The file cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">This user may not write it.</exception>
    public BvhTakeWriter(string path, BvhTakeOptions? options = null)
        : this(WritableFile.Create(path), options)
    {
    }

    /// <summary>Writes to a stream, from its position on. Nothing is written before the first frame.</summary>
    /// <param name="stream">Where; it is closed at the end.</param>
    /// <param name="options">What the frames do not say; null for the defaults.</param>
    /// <exception cref="ArgumentException">The stream cannot seek, and the options do not say the frame time.</exception>
    public BvhTakeWriter(Stream stream, BvhTakeOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(stream);
        _stream = stream;
        _options = options?.Copy() ?? new BvhTakeOptions();
        _sequence = new FrameSequence(_options.GapHandling);
        if (!stream.CanSeek && _options.FrameTime is null)
            throw new ArgumentException("A stream that cannot seek needs FrameTime: a measured frame time is known at the end only.", nameof(stream));
    }

    /// <summary>Number of rows that were written, repeated ones included; once the stream has failed, of those that it holds.</summary>
    public int FrameCount => _writer?.FrameCount ?? 0;

    /// <summary>Number of rows that stand in for frames that were lost.</summary>
    public int RepeatedFrames => _repeated - _recentRepeats.Count(row => row > FrameCount);

    /// <summary>Number of frames that were left out because later ones had come before them, as datagrams may.</summary>
    public int LateFrames { get; private set; }

    /// <summary>Time from one frame to the next, as far as it is known by now.</summary>
    public BvhFrameTime FrameTime => _options.FrameTime ?? _sequence.Measure();

    /// <summary>Whether a frame can become a row of this file: it holds the 59 bones, in the layout, rotation order and variant of those before it.</summary>
    /// <param name="frame">A frame.</param>
    public bool Accepts(MotionFrame frame)
    {
        ArgumentNullException.ThrowIfNull(frame);
        return frame.HasSkeleton && (_writer is null || (frame.Layout == _layout && frame.Format == _format));
    }

    /// <summary>Writes a frame as a row; one that comes late not at all, and one after a gap as <see cref="BvhTakeOptions.GapHandling"/> says.</summary>
    /// <param name="frame">A frame; only read, during the call.</param>
    /// <exception cref="InvalidOperationException"><see cref="Accepts"/> is false.</exception>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    public void Write(MotionFrame frame)
    {
        if (!Accepts(frame))
            throw new InvalidOperationException("The frame has another layout than the file.");

        _writer ??= Begin(frame);
        if (frame.Origin != _origin)
            _sequence.Restart();

        _origin = frame.Origin;
        int rows = _sequence.Next(frame.FrameIndex, frame.Timestamp);
        if (rows == 0)
        {
            LateFrames++;
            return;
        }

        for (int i = 1; i < rows; i++)
            Repeat(_writer);

        frame.Values.CopyTo(_row);
        _writer.WriteFrame(_row);
    }

    /// <summary>Hands all rows to the system, with their number and the frame time: <see cref="BvhWriter.Flush"/>.</summary>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    public void Flush()
    {
        if (_writer is null)
            return;

        PassFrameTime();
        _writer.Flush();
    }

    /// <summary>Completes the file and closes the stream. Again: nothing.</summary>
    /// <exception cref="IOException">The stream cannot be written; it is closed all the same.</exception>
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
            _writer!.FrameTime = _sequence.Measure();
    }

    private BvhWriter Begin(MotionFrame frame)
    {
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
