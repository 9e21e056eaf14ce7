using System.Numerics;
using System.Runtime.InteropServices;
using NeuronMocap.Protocol;
using NeuronMocap.Skeleton;
using NeuronMocap.Timing;
using NeuronMocap.Tool.View.Performers;

namespace NeuronMocap.Tool.View.Takes;

/// <summary>Adds the frames of one performer. Not thread-safe; what it adds can be read by any thread.</summary>
internal sealed class PerformerWriter
{
    private const double DegreesPerRadian = 180 / Math.PI;

    private readonly AvatarName _name;
    private readonly TakeTimes _times;
    private readonly ContactFinder _contacts;
    private readonly FrameTiming _timing = new();
    private readonly FrameMeter _meter = new(BoneHierarchy.BoneCount);
    private readonly ArrivalQueue _arrivals;
    private readonly byte[] _pose = new byte[CompactPose.MaxSize];
    private readonly Vector3[] _places = new Vector3[BoneHierarchy.BoneCount];
    private readonly float[] _angles = new float[BoneHierarchy.BoneCount];
    private readonly float[] _values = new float[BoneHierarchy.BoneCount * FrameMeter.Quantities];
    private readonly float[] _summary = new float[TakePerformer.SummaryValues];
    private (uint? Index, int Connection) _last;
    private long _lastTime = long.MinValue;
    private long _measured;

    /// <summary>Creates a performer without frames.</summary>
    /// <param name="create">Creates a file of records of a size: for the poses, then for the summaries.</param>
    /// <param name="key">Identifies the performer among those of all takes.</param>
    /// <param name="index">Number of the performer in the take, from 0.</param>
    /// <param name="name">Name of the avatar.</param>
    /// <param name="source">Numbers of the sender and the avatar in the file.</param>
    /// <param name="body">The body.</param>
    public PerformerWriter(Func<int, RecordFile> create, string key, int index, AvatarName name, PerformerKey source, SkeletonBody body)
    {
        _name = name;
        _times = new TakeTimes();
        _arrivals = new ArrivalQueue((frame, time) => Write(time, frame.Time, frame.Index, frame.Pose, frame.Measured));
        _contacts = new ContactFinder();
        int nameSize = SizeOf(name);
        RecordFile poses = create(CompactPose.MaxSize - ProtocolConstants.AvatarNameSize + nameSize);
        RecordFile summaries = create(TakePerformer.SummaryValues * sizeof(float));
        Performer = new TakePerformer(key, index, name.ToString(), source, body, poses, summaries, _times, _contacts);
        ClearSummary();
    }

    public TakePerformer Performer { get; }

    /// <summary>Number of frames that were left out because a value is not finite.</summary>
    public long LeftOut { get; private set; }

    /// <summary>Number of frames that were left out because they came after a later one, or twice.</summary>
    public long Late { get; private set; }

    /// <summary>Adds a frame.</summary>
    /// <param name="time">Its time since the start of the take.</param>
    /// <param name="frameIndex">The server's counter; null if there is none.</param>
    /// <param name="connection">Number of its connection.</param>
    /// <param name="local">59 transforms relative to the parent, the hips in the world, centimetres.</param>
    /// <param name="measured">The contacts that the file holds; null if it has none.</param>
    public void Add(TimeSpan time, uint? frameIndex, int connection, ReadOnlySpan<BoneTransform> local, FootContacts? measured)
    {
        bool isRepeated = frameIndex is not null && (frameIndex, connection) == _last;
        int distance = isRepeated ? 0 : _timing.Add(frameIndex, time, connection);
        if (distance == 0)
        {
            Late++;
            return;
        }

        long microseconds = time.Ticks / TimeSpan.TicksPerMicrosecond;
        if (frameIndex is { } index)
            _arrivals.Add(microseconds, index, connection == _last.Connection ? distance : 0, local, measured, _timing.MeasuredRate);
        else
            Write(microseconds, microseconds, null, local, measured);

        _last = (frameIndex, connection);
    }

    /// <summary>Makes what was added readable.</summary>
    /// <exception cref="IOException">Some of it has no room. The rest can be read.</exception>
    public void Flush()
    {
        Performer.Rate = _timing.Rate;
        try
        {
            Performer.Poses.Flush();
        }
        finally
        {
            Performer.Summaries.Flush();
        }
    }

    /// <summary>Completes the performer.</summary>
    /// <exception cref="IOException">Some of it has no room. The rest is complete.</exception>
    public void Finish()
    {
        try
        {
            _arrivals.Finish(_timing.MeasuredRate);
        }
        finally
        {
            FinishWritten();
        }
    }

    /// <summary>The angle of a rotation in degrees, 0 to 180.</summary>
    public static float AngleOf(Quaternion rotation)
    {
        double vector = Math.Sqrt((rotation.X * rotation.X) + (rotation.Y * rotation.Y) + (rotation.Z * rotation.Z));
        return (float)(2 * Math.Atan2(vector, Math.Abs(rotation.W)) * DegreesPerRadian);
    }

    private void Write(long time, long arrival, uint? frameIndex, ReadOnlySpan<BoneTransform> local, FootContacts? measured)
    {
        // Later code relies on times that grow.
        long microseconds = Math.Max(time, _lastTime + 1);
        var header = new CompactPoseHeader
        {
            AvatarIndex = Performer.Index,
            AvatarName = _name,
            FrameIndex = frameIndex,
            Time = DateTimeOffset.UnixEpoch + TimeSpan.FromMicroseconds(microseconds),
            Variant = Performer.Body.Variant,
        };
        if (!CompactPose.TryEncode(header, local, _pose, out int size) || size != Performer.Poses.RecordSize)
        {
            LeftOut++;
            return;
        }

        // Every frame that has a time can be read.
        Performer.Poses.ThrowIfFull();
        Performer.Summaries.ThrowIfFull();
        _lastTime = microseconds;
        bool isAfterGap = _times.Add(microseconds, arrival);
        Performer.Poses.Append(_pose);
        Measure(microseconds, local, isAfterGap, measured);
    }

    private static int SizeOf(AvatarName name)
    {
        Span<byte> bytes = stackalloc byte[ProtocolConstants.AvatarNameSize];
        name.CopyTo(bytes);
        int size = bytes.IndexOf((byte)0);
        return size < 0 ? bytes.Length : size;
    }

    private void Measure(long microseconds, ReadOnlySpan<BoneTransform> local, bool isAfterGap, FootContacts? measured)
    {
        Span<BoneTransform> world = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        Place(local, world);
        for (int bone = 0; bone < BoneHierarchy.BoneCount; bone++)
        {
            _places[bone] = world[bone].Position;
            _angles[bone] = AngleOf(local[bone].Rotation);
        }

        _contacts.Add(world, Performer.Body, microseconds, isAfterGap, measured);
        _meter.Add(microseconds / 1e6, _places, _angles);
        TakeMeasured(atEnd: false);
    }

    // The page shows the body's lengths, so they apply here as well.
    private void Place(ReadOnlySpan<BoneTransform> local, Span<BoneTransform> world)
    {
        ReadOnlySpan<Vector3> offsets = Performer.Body.Offsets;
        world[0] = local[0];
        for (int bone = 1; bone < BoneHierarchy.BoneCount; bone++)
            world[bone] = local[bone] with { Position = offsets[bone] };

        ForwardKinematics.ToWorld(world, world, Performer.Body.Variant);
    }

    private void TakeMeasured(bool atEnd)
    {
        while (_meter.TryTake(atEnd, out _, _values))
        {
            for (int i = 0; i < _values.Length; i++)
            {
                float value = _values[i];
                if (!(_summary[2 * i] <= value) && float.IsFinite(value))
                    _summary[2 * i] = value;
                if (!(_summary[(2 * i) + 1] >= value) && float.IsFinite(value))
                    _summary[(2 * i) + 1] = value;
            }

            if (++_measured % TakeTimes.BlockSize == 0)
                AppendSummary();
        }
    }

    private void FinishWritten()
    {
        try
        {
            TakeMeasured(atEnd: true);
            if (_measured % TakeTimes.BlockSize != 0)
                AppendSummary();
        }
        finally
        {
            _contacts.Finish();
            Flush();
        }
    }

    private void AppendSummary()
    {
        Performer.Summaries.Append(MemoryMarshal.AsBytes(_summary.AsSpan()));
        ClearSummary();
    }

    private void ClearSummary() => _summary.AsSpan().Fill(float.NaN);
}
