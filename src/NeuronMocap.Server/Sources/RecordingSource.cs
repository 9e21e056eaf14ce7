using System.Numerics;
using NeuronMocap.Motion;
using NeuronMocap.Recording;
using NeuronMocap.Server.Sources;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server;

/// <summary>A source that plays one avatar of a recording, or of the raw bytes of a stream.</summary>
/// <remarks>
/// Received frames keep their values bit for bit and follow each other at an even rate. Arrival times jitter, so they only determine the rate.
/// <para>
/// Frames that are missing according to the server's frame index are interpolated, so that the take keeps its duration. After a gap of more than a
/// second the take continues at once. The same applies to a gap of unknown length, such as a new connection.
/// </para>
/// <para>
/// All frames are in memory, with 0.7 or 1.4 KB each. Foot contacts are those of calculation frames of the same avatar, if the recording has
/// them. Otherwise they are estimated from the motion.
/// </para>
/// </remarks>
public sealed class RecordingSource : MotionSource
{
    private readonly RecordedTimeline _timeline;
    private readonly SkeletonBody _body;
    private readonly Lazy<FootContacts[]> _contacts;

    private RecordingSource(RecordedTakeBuilder builder, RecordingMetadata? metadata, double? evenRate)
    {
        AvatarIndex = builder.AvatarIndex!.Value;
        Sender = builder.Sender!.Value;
        AvatarName = builder.AvatarName;
        ReceivedFrames = builder.Rows.Count;
        Layout = builder.Layout;
        Format = builder.Format;
        _timeline = new RecordedTimeline(builder.Rows, Layout, Format.RotationOrder, evenRate);
        _body = RecordedBody.Find(metadata, AvatarIndex, Variant, HasDisplacement) ?? FindBody();
        _contacts = new Lazy<FootContacts[]>(builder.HasContacts ? ReadContacts : EstimateContacts);
        HasMeasuredContacts = builder.HasContacts;
    }

    /// <summary>Index of the avatar on the server.</summary>
    public int AvatarIndex { get; }

    /// <summary>Number of the sender that the frames came from, as <see cref="AvatarFrame.Sender"/> counts. It is 0 except over UDP.</summary>
    public int Sender { get; }

    /// <summary>Name of the avatar in its first frame.</summary>
    public string AvatarName { get; }

    /// <summary>The values that frames carry, as in the first frame. Later frames are converted if the server's settings changed.</summary>
    public ChannelLayout Layout { get; }

    /// <summary>Rotation order and names of the bones.</summary>
    public SkeletonFormat Format { get; }

    /// <summary>Frames per second, estimated from the arrival times. A BVH export of the same stream has the same rate.</summary>
    /// <value>
    /// <list type="bullet">
    /// <item>
    /// The usual rate nearest to the measured one (<see cref="MeasuredFrameRate"/>), if it is within one per cent. A take of less than a
    /// second allows more. If no usual rate is near, the measured rate to a hundredth.
    /// </item>
    /// <item>The rate of the grid if the arrival times lie on an even grid, as in a recording made from a file.</item>
    /// <item>120 if the arrival times do not give a rate.</item>
    /// <item>For raw bytes: <see cref="PlaybackOptions.FrameRate"/>, or the rate of their timecodes, or 120.</item>
    /// </list>
    /// </value>
    /// <remarks>
    /// Usual rates: 24, 25, 30, 48, 50, 60, 72, 75, 80, 90, 96, 100, 120, 125, 144, 150, 180, 200, 240, 250, 300 and 360 Hz.
    /// </remarks>
    public override double FrameRate => _timeline.FrameRate;

    /// <summary>Frames per second according to the arrival times, with missing frames counted. Null if they do not give a rate.</summary>
    /// <remarks>Frames that arrive late, such as a burst when the connection opens, and pauses of the server have no influence.</remarks>
    public double? MeasuredFrameRate => _timeline.MeasuredFrameRate;

    /// <inheritdoc/>
    public override long? FrameCount => _timeline.Rows.Count;

    /// <inheritdoc/>
    public override bool HasDisplacement => Layout.HasDisplacement;

    /// <inheritdoc/>
    public override SkeletonVariant Variant => Format.Variant;

    /// <summary>Number of received frames. A frame that arrived twice counts once.</summary>
    public long ReceivedFrames { get; }

    /// <summary>Number of interpolated frames, which replace missing ones.</summary>
    public long InterpolatedFrames => _timeline.InterpolatedFrames;

    /// <summary>The gaps: places where frames are missing.</summary>
    public IReadOnlyList<RecordedGap> Gaps => _timeline.Gaps;

    /// <summary>
    /// Whether the sizes of the body are those of the performer. False if a stream without displacement leaves only the default sizes.
    /// </summary>
    public bool HasOwnBody => HasDisplacement || _body != SkeletonBody.GetDefault(Variant);

    /// <summary>Whether <see cref="GetFootContacts"/> returns contacts from the server. Otherwise they are estimated.</summary>
    public bool HasMeasuredContacts { get; }

    /// <summary>Loads a file.</summary>
    /// <param name="path">Path of a recording, or of the raw bytes of a stream.</param>
    /// <param name="avatarIndex">Index of the avatar; null for the first avatar that has a pose.</param>
    /// <param name="sender">Number of the sender; null for the first one that sends a pose of the avatar.</param>
    /// <param name="options">How to read the file; null for the format that the file states.</param>
    /// <param name="progress">Receives progress, 0 to 1; may be null.</param>
    /// <param name="cancellationToken">Cancels the reading.</param>
    /// <returns>The source.</returns>
    /// <exception cref="NeuronException">
    /// The file has another format, or it has no pose of the avatar. The message says what the file holds.
    /// </exception>
    /// <exception cref="IOException">The file cannot be opened or read.</exception>
    /// <exception cref="UnauthorizedAccessException">The user does not have permission to read the file.</exception>
    /// <exception cref="OperationCanceledException">The reading was cancelled.</exception>
    public static RecordingSource Load(
        string path,
        int? avatarIndex = null,
        int? sender = null,
        PlaybackOptions? options = null,
        IProgress<double>? progress = null,
        CancellationToken cancellationToken = default)
    {
        using RecordedFrameReader reader = RecordedFrameReader.Open(path, options);
        var builder = new RecordedTakeBuilder(avatarIndex, sender);
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

    /// <summary>
    /// Gets the arrival time of a frame, since the start of the recording. An interpolated frame has the time at which it would have arrived.
    /// </summary>
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

    /// <summary>Gets the values of a frame as received.</summary>
    /// <param name="frame">Frame number, from 0, below <see cref="FrameCount"/>.</param>
    /// <returns>The values of <see cref="Layout"/>, in memory that the source owns.</returns>
    public ReadOnlySpan<float> GetValues(long frame) => _timeline.Rows[checked((int)frame)].Values;

    /// <summary>Gets which feet touch the ground, measured or estimated: see <see cref="HasMeasuredContacts"/>.</summary>
    /// <remarks>For estimates, the first call reads the whole take.</remarks>
    /// <param name="frame">Frame number, from 0, below <see cref="FrameCount"/>.</param>
    /// <returns>True for each foot that touches the ground.</returns>
    public override FootContacts GetFootContacts(long frame) => _contacts.Value[checked((int)frame)];

    /// <summary>Writes the body at rest.</summary>
    /// <remarks>
    /// If the metadata of the recording hold a hierarchy, it is that body. Otherwise a stream with displacement gives the body of its first frame.
    /// Without displacement, the twelve sizes in the metadata give the body; they come from the command channel. Without them, it is the default
    /// body.
    /// </remarks>
    /// <param name="offsets">Room for 59 bone positions relative to the parent bone, in <see cref="Bone"/> order; centimetres.</param>
    /// <param name="endSites">Room for 59 end points of bones, relative to the bone. Zero for bones that have children.</param>
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
        ? "It has no motion frame with the 59 bones."
        : $"It has no pose of {DescribeWanted(builder)}; there {(builder.Others.Count == 1 ? "is" : "are")} "
            + string.Join(", ", builder.Others.Select(static other => $"{DescribeAvatar(other.Key.Avatar, other.Key.Sender)} ({other.Value})")) + ".";

    private static string DescribeWanted(RecordedTakeBuilder builder) =>
        builder.AvatarIndex is { } avatar ? $"avatar {DescribeAvatar(avatar, builder.Sender ?? 0)}" : $"sender {builder.Sender}";

    private static string DescribeAvatar(int avatar, int sender) => sender == 0 ? $"{avatar}" : $"{avatar} of sender {sender}";

    private SkeletonBody FindBody()
    {
        if (!Layout.HasDisplacement)
            return SkeletonBody.GetDefault(Variant);

        Span<BoneTransform> pose = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        foreach (Bone bone in BoneHierarchy.Bones)
            pose[(int)bone] = PoseValues.Read(_timeline.Rows[0].Values, Layout, Format.RotationOrder, bone, default);

        return SkeletonBody.FromPose(pose, Variant);
    }

    // A frame without a calculation frame has the contacts of the previous frame.
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
