using NeuronMocap.Skeleton;

namespace NeuronMocap.Bvh;

/// <summary>
/// What is done to takes: each operation makes a new document and leaves the old one as it is. Poses are computed in double precision; what does not
/// have to change keeps its bits. Times stay fractions. All but <see cref="WithVariant"/> work with any hierarchy.
/// </summary>
public static class BvhEditing
{
    /// <summary>A part of a take, by frame numbers.</summary>
    /// <param name="document">The take.</param>
    /// <param name="start">The first frame of the part, from 0.</param>
    /// <param name="count">Number of frames.</param>
    /// <returns>The part.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The part reaches beyond the take.</exception>
    public static BvhDocument Trim(this BvhDocument document, int start, int count)
    {
        ArgumentNullException.ThrowIfNull(document);
        if (start < 0 || start > document.FrameCount)
            throw new ArgumentOutOfRangeException(nameof(start), start, $"There are {document.FrameCount} frames.");
        if (count < 0 || count > document.FrameCount - start)
            throw new ArgumentOutOfRangeException(nameof(count), count, $"There are {document.FrameCount} frames.");

        float[] values = new float[count * document.ChannelCount];
        for (int frame = 0; frame < count; frame++)
            document.GetFrame(start + frame).CopyTo(values.AsSpan(frame * document.ChannelCount));

        return document.With(document.Hierarchy, values);
    }

    /// <summary>A part of a take, by time: the frames from the one nearest to the start to the one before the one nearest to the end.</summary>
    /// <param name="document">The take.</param>
    /// <param name="start">Time of the first frame since that of the take.</param>
    /// <param name="duration">How long the part lasts.</param>
    /// <returns>The part.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The part reaches beyond the take.</exception>
    public static BvhDocument Trim(this BvhDocument document, TimeSpan start, TimeSpan duration)
    {
        ArgumentNullException.ThrowIfNull(document);
        int first = FrameAt(document, start, nameof(start));
        return document.Trim(first, FrameAt(document, start + duration, nameof(duration)) - first);
    }

    /// <summary>Puts takes of one hierarchy one after the other.</summary>
    /// <param name="takes">
    /// The takes, in order; at least one. Names, parents and channels of the joints have to be the same, and so have offsets that a position channel does
    /// not replace, and the frame time: see <see cref="WithRotationOrder"/>, <see cref="WithDisplacement"/>, <see cref="Resample(BvhDocument, BvhFrameTime)"/>.
    /// </param>
    /// <param name="isAligned">
    /// Whether each take begins where the one before ends: moved along the ground and turned about the vertical as a whole, so that the hips stand at the same
    /// place and face the same way. Heights stay. Frames are not blended. Without, the values stay as they are.
    /// </param>
    /// <returns>The whole, with the hierarchy of the first.</returns>
    /// <exception cref="ArgumentException">There is no take.</exception>
    /// <exception cref="NeuronException">The takes do not fit together; the message says where they differ.</exception>
    public static BvhDocument Join(IReadOnlyList<BvhDocument> takes, bool isAligned = false) => BvhJoining.Join(takes, isAligned);

    /// <summary>
    /// The same motion at another rate: rotations are interpolated along the shortest way between quaternions, positions along straight lines. Frames at
    /// times at which the take has one keep its bits, so that 120 Hz made 60 Hz is every second row. The first and the last frame are kept; where the length of
    /// the take is no whole number of frames, the last one comes later by less than a frame.
    /// </summary>
    /// <param name="document">The take.</param>
    /// <param name="frameTime">Time from one frame to the next, above 0.</param>
    /// <returns>The take at that rate. The angles are those nearest to the neighbours' in the take.</returns>
    /// <exception cref="ArgumentException">The time is none, or there would be more frames than a document can have.</exception>
    public static BvhDocument Resample(this BvhDocument document, BvhFrameTime frameTime) => BvhResampling.Resample(document, frameTime);

    /// <summary>The same motion at another rate; otherwise as with a <see cref="BvhFrameTime"/>.</summary>
    /// <param name="document">The take.</param>
    /// <param name="frameRate">Frames per second.</param>
    /// <returns>The take at that rate.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The rate is none: <see cref="BvhFrameTime.FromFrameRate"/>.</exception>
    public static BvhDocument Resample(this BvhDocument document, double frameRate) => Resample(document, BvhFrameTime.FromFrameRate(frameRate));

    /// <summary>
    /// The take as a mirror shows it: what left did, right does, and the other way round. Everything is reflected in the plane X = 0, which is the
    /// subject's middle in Axis Neuron's axes. Mirrored twice it is the take again, bit for bit. Which joint is whose partner follows from names: LeftArm and RightArm,
    /// lArm and rArm, Arm.L and Arm.R, Arm_l and Arm_r, LHip and RHip; a joint without a partner is its own. A joint gets offset, channels and values of its partner.
    /// </summary>
    /// <param name="document">The take.</param>
    /// <returns>The mirrored take, its joints in the same order.</returns>
    /// <exception cref="NeuronException">The joints of the two sides do not correspond; the message says which.</exception>
    public static BvhDocument Mirror(this BvhDocument document) => BvhMirroring.Mirror(document);

    /// <summary>
    /// The take with another order of rotation, the same for every joint that has one channel for each axis; others stay as they are. The pose is the
    /// same. Of the triples that describe a rotation, the one nearest to that of the frame before is chosen, so that curves do not jump; angles may then
    /// leave -180 to 180 degrees. Joints that have the order already keep their values.
    /// </summary>
    /// <param name="document">The take.</param>
    /// <param name="order">The order of the channels, which is that of their application.</param>
    /// <returns>The take in that order.</returns>
    /// <exception cref="ArgumentOutOfRangeException">There is no such order.</exception>
    public static BvhDocument WithRotationOrder(this BvhDocument document, RotationOrder order) => BvhRotationOrderChange.WithOrder(document, order);

    /// <summary>
    /// The take with the same poses and without jumps between triples of angles that describe the same rotation: in each frame the one nearest to that
    /// of the frame before. Programs call it an Euler filter. Streams and recordings of Neuron do jump.
    /// </summary>
    /// <param name="document">The take.</param>
    /// <returns>The take with continuous curves.</returns>
    public static BvhDocument FilterEulerAngles(this BvhDocument document) => BvhRotationOrderChange.Filter(document);

    /// <summary>The take with position channels for every joint: those that had none get three, in front of the others, that hold the OFFSET.</summary>
    /// <param name="document">The take.</param>
    /// <returns>The take with displacement.</returns>
    public static BvhDocument WithDisplacement(this BvhDocument document) => BvhDisplacementChange.Add(document);

    /// <summary>
    /// The take without position channels but those of the roots and, where the root is a node named Reference, of what hangs from it. An OFFSET becomes
    /// the middle one of the positions that the joint had in the take (the median of each coordinate), so that nothing is lost where they did not change.
    /// </summary>
    /// <param name="document">The take.</param>
    /// <param name="loss">How far the positions that were dropped were from the new OFFSETs.</param>
    /// <returns>The take without displacement.</returns>
    public static BvhDocument WithoutDisplacement(this BvhDocument document, out PositionChannelLoss loss) => BvhDisplacementChange.Remove(document, out loss);

    /// <summary>
    /// A take of Neuron's 59 bones with the names and parents of the other variant. Every joint stays where it is in the world, and turned as it was. The
    /// shoulders hang from another bone, which moves by itself: a take without displacement gets it where that bone turns, because no fixed OFFSET could follow.
    /// </summary>
    /// <param name="document">The take.</param>
    /// <param name="variant">The naming of spine and neck.</param>
    /// <returns>The take in that variant; the same document where it is in it already.</returns>
    /// <exception cref="NeuronException">The skeleton is not Neuron's; the message says what is different.</exception>
    public static BvhDocument WithVariant(this BvhDocument document, SkeletonVariant variant) => BvhVariantChange.Change(document, variant);

    // Of the same rate and layout of the text.
    internal static BvhDocument With(this BvhDocument document, BvhHierarchy hierarchy, float[] values) =>
        new(hierarchy, document.FrameTime, values) { TextFormat = document.TextFormat };

    internal static float[] CopyValues(this BvhDocument document)
    {
        float[] values = new float[document.FrameCount * document.ChannelCount];
        for (int frame = 0; frame < document.FrameCount; frame++)
            document.GetFrame(frame).CopyTo(values.AsSpan(frame * document.ChannelCount));

        return values;
    }

    // For a hierarchy of the same joints, with as many channels each.
    internal static float[] CopyValues(this BvhDocument document, BvhHierarchy hierarchy)
    {
        float[] values = new float[document.FrameCount * document.ChannelCount];
        for (int frame = 0; frame < document.FrameCount; frame++)
        {
            ReadOnlySpan<float> from = document.GetFrame(frame);
            Span<float> to = values.AsSpan(frame * document.ChannelCount, document.ChannelCount);
            foreach (BvhJoint joint in document.Joints)
                from.Slice(joint.FirstChannel, joint.Channels.Count).CopyTo(to[hierarchy.Joints[joint.Index].FirstChannel..]);
        }

        return values;
    }

    internal static BvhJointValues[] GetJointValues(this BvhHierarchy hierarchy) => [.. hierarchy.Joints.Select(static joint => new BvhJointValues(joint))];

    private static int FrameAt(BvhDocument document, TimeSpan time, string name)
    {
        decimal seconds = time.Ticks / (decimal)TimeSpan.TicksPerSecond;
        decimal frame = decimal.Round(seconds * document.FrameTime.Denominator / document.FrameTime.Numerator);
        if (frame < 0 || frame > document.FrameCount)
        {
            double end = document.FrameCount * document.FrameTime.Seconds;
            throw new ArgumentOutOfRangeException(name, time, $"The take ends after {end.ToString("F3", System.Globalization.CultureInfo.InvariantCulture)} s.");
        }

        return (int)frame;
    }
}
