using System.Numerics;
using NeuronMocap.Motion;
using NeuronMocap.Recording;
using NeuronMocap.Server.Sources;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server;

/// <summary>
/// One avatar of a recording, or of the raw bytes of a stream. The frames that were received keep their values, bit for bit, one after the other at an
/// even rate; arrival times, which jitter, only tell the rate. Frames that the server's index says are missing are interpolated, so that the take
/// keeps its time; behind a gap of more than a second, or one of unknown length such as a new connection, it goes on at once.
/// <para>
/// All frames are in memory: 0.7 or 1.4 KB for each. Contacts of the feet are those of calculation frames of the same avatar, where the recording
/// has such; else they are estimated from the motion.
/// </para>
/// </summary>
public sealed class RecordingSource : MotionSource
{
    private readonly RecordedTimeline _timeline;
    private readonly SkeletonBody _body;
    private readonly Lazy<FootContacts[]> _contacts;

    private RecordingSource(RecordedTakeBuilder builder, RecordingMetadata? metadata, double? evenRate)
    {
        AvatarIndex = builder.AvatarIndex!.Value;
        AvatarName = builder.AvatarName;
        ReceivedFrames = builder.Rows.Count;
        Layout = builder.Layout;
        Format = builder.Format;
        _timeline = new RecordedTimeline(builder.Rows, Layout, Format.RotationOrder, evenRate);
        _body = RecordedBody.Find(metadata, AvatarIndex, Variant, HasDisplacement) ?? FindBody();
        _contacts = new Lazy<FootContacts[]>(builder.HasContacts ? ReadContacts : EstimateContacts);
        HasMeasuredContacts = builder.HasContacts;
    }

    /// <summary>Number of the avatar on the server.</summary>
    public int AvatarIndex { get; }

    /// <summary>Name of the avatar, of its first frame.</summary>
    public string AvatarName { get; }

    /// <summary>Which values the frames have: those of the first one; further ones are rewritten where the server was set differently later.</summary>
    public ChannelLayout Layout { get; }

    /// <summary>Rotation order and naming of the bones.</summary>
    public SkeletonFormat Format { get; }

    /// <summary>
    /// The measured rate (<see cref="MeasuredFrameRate"/>), or the usual one (24, 25, 30, 48, 50, 60, 72, 75, 80, 90, 96, 100, 120, 144, 150, 180, 200, 240,
    /// 300 or 360 Hz) within one per cent of it; 120 where arrival times do not tell. Where they stand on an even grid, as of a recording that was made of a
    /// file, the rate of the grid, whatever it is: <see cref="FrameRateEstimator"/>. Of raw bytes, <see cref="PlaybackOptions.FrameRate"/>, or the rate
    /// of their timecodes, or 120.
    /// </summary>
    public override double FrameRate => _timeline.FrameRate;

    /// <summary>Frames per second by the arrival times, missing ones counted; null where these do not tell.</summary>
    public double? MeasuredFrameRate => _timeline.MeasuredFrameRate;

    /// <inheritdoc/>
    public override long? FrameCount => _timeline.Rows.Count;

    /// <inheritdoc/>
    public override bool HasDisplacement => Layout.HasDisplacement;

    /// <inheritdoc/>
    public override SkeletonVariant Variant => Format.Variant;

    /// <summary>Frames that were received; one that came twice counts once.</summary>
    public long ReceivedFrames { get; }

    /// <summary>Frames that stand for missing ones.</summary>
    public long InterpolatedFrames => _timeline.InterpolatedFrames;

    /// <summary>Where frames are missing.</summary>
    public IReadOnlyList<RecordedGap> Gaps => _timeline.Gaps;

    /// <summary>Whether the sizes of the body are the actor's: false where a stream without displacement leaves only the default ones.</summary>
    public bool HasOwnBody => HasDisplacement || _body != SkeletonBody.GetDefault(Variant);

    /// <summary>Whether <see cref="GetFootContacts"/> is what the server measured, not an estimate.</summary>
    public bool HasMeasuredContacts { get; }

    /// <summary>Reads a file.</summary>
    /// <param name="path">A recording, or the raw bytes of a stream.</param>
    /// <param name="avatarIndex">Which avatar; null for the first one that has a pose.</param>
    /// <param name="options">How to read it; null for what the file says.</param>
    /// <param name="progress">Told the part that is done, 0 to 1; null for nobody.</param>
    /// <param name="cancellationToken">Ends the reading.</param>
    /// <returns>The source.</returns>
    /// <exception cref="NeuronException">The file is neither, or has no pose of the avatar; the message says what it has.</exception>
    /// <exception cref="IOException">The file cannot be opened or read.</exception>
    /// <exception cref="UnauthorizedAccessException">The file may not be read.</exception>
    /// <exception cref="OperationCanceledException">The reading was ended.</exception>
    public static RecordingSource Load(
        string path,
        int? avatarIndex = null,
        PlaybackOptions? options = null,
        IProgress<double>? progress = null,
        CancellationToken cancellationToken = default)
    {
        using RecordedFrameReader reader = RecordedFrameReader.Open(path, options);
        var builder = new RecordedTakeBuilder(avatarIndex);
        while (reader.Read())
        {
            cancellationToken.ThrowIfCancellationRequested();
            builder.Add(reader.Frame, reader.Time, reader.Connection);
            progress?.Report(reader.Duration > TimeSpan.Zero ? Math.Min(reader.Time / reader.Duration, 1) : 0);
        }

        return builder.Rows.Count > 0
            ? new RecordingSource(builder, RecordedBody.ReadMetadata(path), reader.EvenRate)
            : throw new NeuronException(DescribeLack(builder));
    }

    /// <summary>The rate that a server is set to, from a measured one: see <see cref="FrameRate"/>.</summary>
    /// <param name="measured">Frames per second.</param>
    /// <returns>A usual rate within one per cent of it, or itself.</returns>
    public static double ChooseFrameRate(double measured) => RecordedTimeline.ChooseFrameRate(measured);

    /// <summary>When a frame arrived, since the recording's start; of an interpolated one, when it would have.</summary>
    /// <param name="frame">Frame number, from 0, below <see cref="FrameCount"/>.</param>
    /// <returns>The time.</returns>
    public TimeSpan GetTime(long frame) => _timeline.Rows[checked((int)frame)].Time;

    /// <inheritdoc/>
    public override void GetPose(long frame, Span<BoneTransform> pose)
    {
        ReadOnlySpan<float> values = GetValues(frame);
        foreach (Bone bone in BoneHierarchy.Bones)
            pose[(int)bone] = PoseValues.Read(values, Layout, Format.RotationOrder, bone, _body.Offsets);

        if (Layout.HasReference)
            pose[0] = PoseValues.ReadReference(values, Layout, Format.RotationOrder).Apply(pose[0]);
    }

    /// <summary>The values of a frame, as received.</summary>
    /// <param name="frame">Frame number, from 0, below <see cref="FrameCount"/>.</param>
    /// <returns>As many as <see cref="Layout"/> has, in the source's own memory.</returns>
    public ReadOnlySpan<float> GetValues(long frame) => _timeline.Rows[checked((int)frame)].Values;

    /// <summary>Which feet are on the ground: see <see cref="HasMeasuredContacts"/>. The first call for an estimate reads the whole take.</summary>
    /// <param name="frame">Frame number, from 0, below <see cref="FrameCount"/>.</param>
    /// <returns>True for each foot that touches.</returns>
    public override FootContacts GetFootContacts(long frame) => _contacts.Value[checked((int)frame)];

    /// <summary>
    /// Writes the body: the one whose hierarchy is in the recording's metadata; else with displacement that of the first frame, and without that of the
    /// twelve sizes in the metadata, which the command channel told, or the default one.
    /// </summary>
    /// <param name="offsets">Room for the places of the 59 bones relative to their parents, in <see cref="Bone"/> order; centimetres.</param>
    /// <param name="endSites">Room for 59 places where the bones end, relative to them; zero for bones that have children.</param>
    public override void GetBody(Span<Vector3> offsets, Span<Vector3> endSites)
    {
        _body.Offsets.CopyTo(offsets);
        _body.EndSites.CopyTo(endSites);
    }

    /// <inheritdoc/>
    public override void WriteValues(long frame, ChannelLayout layout, RotationOrder order, Span<float> values)
    {
        if (layout == Layout && order == Format.RotationOrder)
            GetValues(frame).CopyTo(values);
        else
            base.WriteValues(frame, layout, order, values);
    }

    private static string DescribeLack(RecordedTakeBuilder builder) => builder.Others.Count == 0
        ? "It has no pose: no motion frame of the 59 bones."
        : $"It has no pose of avatar {builder.AvatarIndex}; there {(builder.Others.Count == 1 ? "is" : "are")} "
            + string.Join(", ", builder.Others.Select(static other => $"{other.Key} ({other.Value})")) + ".";

    private SkeletonBody FindBody()
    {
        if (!Layout.HasDisplacement)
            return SkeletonBody.GetDefault(Variant);

        Span<BoneTransform> pose = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        foreach (Bone bone in BoneHierarchy.Bones)
            pose[(int)bone] = PoseValues.Read(_timeline.Rows[0].Values, Layout, Format.RotationOrder, bone, default);

        return SkeletonBody.FromPose(pose, Variant);
    }

    // A frame whose calculation frame is missing has the contacts of the one before.
    private FootContacts[] ReadContacts()
    {
        var contacts = new FootContacts[_timeline.Rows.Count];
        FootContacts known = _timeline.Rows.FirstOrDefault(static row => row.Contacts is not null)?.Contacts ?? default;
        for (int i = 0; i < contacts.Length; i++)
            contacts[i] = known = _timeline.Rows[i].Contacts ?? known;

        return contacts;
    }

    private FootContacts[] EstimateContacts()
    {
        var feet = new FootContactTrack();
        Span<BoneTransform> pose = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        for (int frame = 0; frame < _timeline.Rows.Count; frame++)
        {
            GetPose(frame, pose);
            ForwardKinematics.ToWorld(pose, pose, Variant);
            feet.Add(pose, _body, frame / FrameRate);
        }

        return feet.EstimateContacts();
    }
}
