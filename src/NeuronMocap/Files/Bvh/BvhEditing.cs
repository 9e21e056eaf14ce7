using NeuronMocap.Skeleton;

namespace NeuronMocap.Bvh;

/// <summary>
/// Edits takes. Each operation creates a new document and leaves the original unchanged.
/// </summary>
/// <remarks>
/// Poses are computed in double precision. Values that do not have to change keep their bits. Times stay exact fractions. All operations except
/// <see cref="WithVariant"/> work with any hierarchy.
/// </remarks>
public static class BvhEditing
{
    /// <summary>Gets a part of a take, by frame numbers.</summary>
    /// <param name="document">The take.</param>
    /// <param name="start">The first frame of the part, from 0.</param>
    /// <param name="count">Number of frames.</param>
    /// <returns>The part.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The part extends beyond the take.</exception>
    public static BvhDocument Trim(this BvhDocument document, int start, int count)
    {
        ArgumentNullException.ThrowIfNull(document);
        if (start < 0 || start > document.FrameCount)
            throw new ArgumentOutOfRangeException(nameof(start), start, $"The part must begin within the {document.FrameCount} frames of the take.");
        if (count < 0 || count > document.FrameCount - start)
            throw new ArgumentOutOfRangeException(nameof(count), count, $"The part must end within the {document.FrameCount} frames of the take.");

        float[] values = new float[count * document.ChannelCount];
        for (int frame = 0; frame < count; frame++)
            document.GetValues(start + frame).CopyTo(values.AsSpan(frame * document.ChannelCount));

        return document.With(document.Hierarchy, values);
    }

    /// <summary>
    /// Gets a part of a take, by time. The part starts at the frame nearest to the start and ends before the frame nearest to the end.
    /// </summary>
    /// <param name="document">The take.</param>
    /// <param name="start">The time of the part's first frame, from the start of the take.</param>
    /// <param name="duration">The duration of the part.</param>
    /// <returns>The part.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The part extends beyond the take, or ends before it begins.</exception>
    public static BvhDocument Trim(this BvhDocument document, TimeSpan start, TimeSpan duration)
    {
        ArgumentNullException.ThrowIfNull(document);
        int first = FrameAt(document, start.Ticks, start, nameof(start));
        int end = FrameAt(document, (decimal)start.Ticks + duration.Ticks, duration, nameof(duration));
        if (end < first)
            throw new ArgumentOutOfRangeException(nameof(duration), duration, "The part must not end before it begins.");

        return document.Trim(first, end - first);
    }

    /// <summary>Joins takes that have the same hierarchy, one after the other.</summary>
    /// <param name="takes">
    /// The takes, in order; at least one. Names, parents and channels of the joints must be the same. The frame times must also be the same, and
    /// all offsets that position channels do not replace. See <see cref="WithRotationOrder"/>, <see cref="WithDisplacement"/>,
    /// <see cref="Resample(BvhDocument, BvhFrameTime)"/>.
    /// </param>
    /// <param name="align">
    /// Whether each take begins where the previous one ends. If true, each take is moved along the ground and turned about the vertical, as a
    /// whole. The hips then stand at the same place and face the same way. Heights do not change, and frames are not blended. If false, the values
    /// do not change.
    /// </param>
    /// <returns>The joined take, with the hierarchy of the first one.</returns>
    /// <exception cref="ArgumentException">
    /// The list is empty or contains null, or the result would have more frames than a document can hold.
    /// </exception>
    /// <exception cref="NeuronException">The takes do not match; the message names the difference.</exception>
    public static BvhDocument Join(IReadOnlyList<BvhDocument> takes, bool align = false) => BvhJoining.Join(takes, align);

    /// <summary>
    /// Converts a take to another frame rate. Rotations are interpolated along the shortest path between quaternions, positions along straight
    /// lines.
    /// </summary>
    /// <remarks>
    /// Frames whose times exist in the original keep their bits; converting 120 Hz to 60 Hz therefore keeps every second row. The first and the
    /// last frame are kept. If the length of the take is not a whole number of frames, the last frame moves later by less than one frame.
    /// </remarks>
    /// <param name="document">The take.</param>
    /// <param name="frameTime">Time from one frame to the next, above 0.</param>
    /// <returns>The take at that rate. Its angles are those nearest to the neighbouring angles of the original.</returns>
    /// <exception cref="ArgumentException">The frame time is 0, or the result would have more frames than a document can hold.</exception>
    public static BvhDocument Resample(this BvhDocument document, BvhFrameTime frameTime) => BvhResampling.Resample(document, frameTime);

    /// <summary>Converts a take to another frame rate, given in frames per second.</summary>
    /// <param name="document">The take.</param>
    /// <param name="frameRate">Frames per second.</param>
    /// <returns>The take at that rate.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The rate is out of range, see <see cref="BvhFrameTime.FromFrameRate"/>.</exception>
    public static BvhDocument Resample(this BvhDocument document, double frameRate) => Resample(document, BvhFrameTime.FromFrameRate(frameRate));

    /// <summary>
    /// Mirrors a take: left and right change places. Everything is reflected in the plane X = 0, which is the middle of the body in the axes of
    /// Axis Neuron.
    /// </summary>
    /// <remarks>
    /// <para>Mirroring twice gives the original, bit for bit. A joint receives the offset, channels and values of its partner.</para>
    /// <para>
    /// Partners are found by name: LeftArm and RightArm, lArm and rArm, Arm.L and Arm.R, Arm_l and Arm_r, LHip and RHip. A joint without a partner
    /// is its own partner.
    /// </para>
    /// </remarks>
    /// <param name="document">The take.</param>
    /// <returns>The mirrored take, with its joints in the same order.</returns>
    /// <exception cref="NeuronException">The joints of the two sides do not match; the message names them.</exception>
    public static BvhDocument Mirror(this BvhDocument document) => BvhMirroring.Mirror(document);

    /// <summary>
    /// Converts a take to another rotation order. The poses do not change.
    /// </summary>
    /// <remarks>
    /// The order applies to every joint that has one rotation channel for each axis; other joints do not change. Several angle triples describe the
    /// same rotation. The one nearest to the previous frame is chosen, which keeps the curves continuous. Angles may therefore leave the range -180
    /// to 180 degrees. Joints that already have the order keep their values.
    /// </remarks>
    /// <param name="document">The take.</param>
    /// <param name="order">The order of the channels, in which the rotations are applied.</param>
    /// <returns>The take in that order.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The rotation order is not defined.</exception>
    public static BvhDocument WithRotationOrder(this BvhDocument document, RotationOrder order) => BvhRotationOrderChange.WithOrder(document, order);

    /// <summary>
    /// Removes jumps between angle triples that describe the same rotation. The poses do not change.
    /// </summary>
    /// <remarks>
    /// In each frame, the triple nearest to the previous frame is chosen. Other programs call this an Euler filter. Streams and recordings of
    /// Neuron contain such jumps.
    /// </remarks>
    /// <param name="document">The take.</param>
    /// <returns>The take with continuous curves.</returns>
    public static BvhDocument FilterEulerAngles(this BvhDocument document) => BvhRotationOrderChange.Filter(document);

    /// <summary>
    /// Adds position channels to every joint. Joints without them receive three, before their other channels, filled with the OFFSET.
    /// </summary>
    /// <param name="document">The take.</param>
    /// <returns>The take with displacement.</returns>
    public static BvhDocument WithDisplacement(this BvhDocument document) => BvhDisplacementChange.Add(document);

    /// <summary>
    /// Removes all position channels except those of the roots. If a root is named Reference, its children keep theirs too.
    /// </summary>
    /// <remarks>
    /// The new OFFSET of a joint is the median of each coordinate of its positions in the take. Positions that never change are therefore kept
    /// exactly.
    /// </remarks>
    /// <param name="document">The take.</param>
    /// <param name="loss">The largest distance between a removed position and its new OFFSET.</param>
    /// <returns>The take without displacement.</returns>
    public static BvhDocument WithoutDisplacement(this BvhDocument document, out PositionChannelLoss loss) => BvhDisplacementChange.Remove(document, out loss);

    /// <summary>
    /// Converts a take of the 59 Neuron bones to the names and parents of the other variant. Every joint keeps its position and rotation in the
    /// world.
    /// </summary>
    /// <remarks>
    /// The shoulders are attached to another bone, which moves independently. If that bone turns, a take without displacement receives
    /// displacement, because a fixed OFFSET cannot follow the bone.
    /// </remarks>
    /// <param name="document">The take.</param>
    /// <param name="variant">The names of spine and neck.</param>
    /// <returns>The take in that variant; the same document if it already has that variant.</returns>
    /// <exception cref="NeuronException">The skeleton is not the Neuron skeleton; the message names the difference.</exception>
    public static BvhDocument WithVariant(this BvhDocument document, SkeletonVariant variant) => BvhVariantChange.Change(document, variant);

    // Keeps the frame time and the text layout.
    internal static BvhDocument With(this BvhDocument document, BvhHierarchy hierarchy, float[] values) =>
        new(hierarchy, document.FrameTime, values) { TextFormat = document.TextFormat };

    internal static float[] CopyValues(this BvhDocument document)
    {
        float[] values = new float[document.FrameCount * document.ChannelCount];
        for (int frame = 0; frame < document.FrameCount; frame++)
            document.GetValues(frame).CopyTo(values.AsSpan(frame * document.ChannelCount));

        return values;
    }

    // For a hierarchy whose joints are the same and have the same number of channels.
    internal static float[] CopyValues(this BvhDocument document, BvhHierarchy hierarchy)
    {
        float[] values = new float[document.FrameCount * document.ChannelCount];
        for (int frame = 0; frame < document.FrameCount; frame++)
        {
            ReadOnlySpan<float> from = document.GetValues(frame);
            Span<float> to = values.AsSpan(frame * document.ChannelCount, document.ChannelCount);
            foreach (BvhJoint joint in document.Joints)
                from.Slice(joint.FirstChannel, joint.Channels.Count).CopyTo(to[hierarchy.Joints[joint.Index].FirstChannel..]);
        }

        return values;
    }

    internal static BvhJointValues[] GetJointValues(this BvhHierarchy hierarchy) => [.. hierarchy.Joints.Select(static joint => new BvhJointValues(joint))];

    // The time is given in ticks. The argument that defines it is for the message.
    private static int FrameAt(BvhDocument document, decimal ticks, TimeSpan argument, string name)
    {
        (long numerator, long denominator) = (document.FrameTime.Numerator, document.FrameTime.Denominator);
        decimal seconds = ticks / TimeSpan.TicksPerSecond;

        // The exact product fits a decimal for all times near the take.
        double estimate = (double)seconds * denominator / numerator;
        decimal frame = estimate >= -1 && estimate <= document.FrameCount + 1.0 ? decimal.Round(seconds * denominator / numerator) : -1;
        if (frame < 0 || frame > document.FrameCount)
        {
            double end = document.FrameCount * document.FrameTime.Seconds;
            throw new ArgumentOutOfRangeException(name, argument, $"The take ends after {end.ToString("F3", System.Globalization.CultureInfo.InvariantCulture)} s.");
        }

        return (int)frame;
    }
}
