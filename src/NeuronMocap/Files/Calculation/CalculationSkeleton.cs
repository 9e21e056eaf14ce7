using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Calculation;

/// <summary>
/// Reconstructs the skeleton of a take of calculation data, which contains only the centres of bones and the rotations of sensors. Immutable;
/// thread-safe.
/// </summary>
/// <remarks>
/// <para>
/// The way centres and sensors move together shows where the joints are, how long the bones are, and how the sensors are mounted. Poses of the 59
/// bones follow from these measurements.
/// </para>
/// <para>
/// A bone has the rotation of its sensor. It is then turned along the shortest path to its recorded centre. Only the feet may move relative to the
/// body, because the server holds them to the ground when both stand. See docs/guide/calculation.md for a comparison with recorded data.
/// Finger motion is unknown: fingers follow the hand.
/// </para>
/// </remarks>
public sealed class CalculationSkeleton
{
    // More frames of a take do not add information.
    private const int MaxFrames = 2000;

    private const string EndsOfBones = "This calculation export contains the ends of the bones instead of their centres: its thighs begin at the hips, without a "
        + "hip width. Poses cannot be computed, because the hip joints and the sensor mountings cannot be found. Its rows can still be read and copied.";

    private const string NoWholeFrame = "Every frame of this calculation export has a position that is not a number. Poses cannot be computed, because the body "
        + "cannot be measured.";

    private readonly BodyMeasurement _measurement;
    private readonly Vector3[] _offsets;
    private readonly CalculationAxes _axes;

    private CalculationSkeleton(CalculationDocument take, CalculationAxes axes)
    {
        _axes = axes;
        int[] frames = FindFinite(take, axes);
        if (frames.Length == 0)
            throw new CalculationFormatException(NoWholeFrame);
        if (BonePoints.AreEnds(take, axes, frames))
            throw new CalculationFormatException(EndsOfBones);

        _measurement = BodyMeasurement.Of(take, axes, frames);
        _offsets = _measurement.CreateOffsets();
        Vector3[] ends = _measurement.CreateEndSites();
        Span<BoneTransform> rest = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        for (int bone = 0; bone < rest.Length; bone++)
            rest[bone] = new BoneTransform(_offsets[bone], Quaternion.Identity);

        Body = SkeletonBody.FromPose(rest, _measurement.Variant, ends);
        GroundHeight = MeasureGround(take, frames);
        Warnings = BodyPlausibility.Find(_offsets);
    }

    /// <summary>The body of the actor.</summary>
    public SkeletonBody Body { get; }

    /// <summary>
    /// Height of the ground in the world of the take, whose origin is at the hips at the start of the recording; centimetres. This is the average
    /// height of the toes of standing feet. Poses are relative to a ground at height zero.
    /// </summary>
    public float GroundHeight { get; }

    /// <summary>
    /// Warnings about implausible lengths, as English sentences; empty when all lengths are plausible. One example is legs that differ by tens of
    /// centimetres. Such lengths show that the values have another meaning than this library assumes, or that a sensor failed.
    /// </summary>
    public IReadOnlyList<string> Warnings { get; }

    /// <summary>Measures the skeleton of a take.</summary>
    /// <param name="take">
    /// The take. Bones that do not move in it have positions as in the default body. Frames with a position that is not a number are not measured.
    /// </param>
    /// <param name="axes">The axes of the take; null for <see cref="CalculationAxes.Export"/>.</param>
    /// <returns>The skeleton, which does not keep a reference to the take.</returns>
    /// <exception cref="CalculationFormatException">
    /// The take contains the ends of the bones instead of their centres, or each frame has a position that is not a number.
    /// </exception>
    public static CalculationSkeleton Measure(CalculationDocument take, CalculationAxes? axes = null)
    {
        ArgumentNullException.ThrowIfNull(take);
        return new CalculationSkeleton(take, axes ?? CalculationAxes.Export);
    }

    /// <summary>Computes the pose of a frame without allocating memory.</summary>
    /// <param name="values">946 or 338 values of the take. Values of another take are valid if the actor kept the sensors on in between.</param>
    /// <param name="pose">Receives 59 transforms relative to the parent, in <see cref="Bone"/> order, in the axes of BVH; centimetres.</param>
    /// <exception cref="ArgumentException">The number of values is wrong, or the destination is too short.</exception>
    public void CopyLocalTransforms(ReadOnlySpan<float> values, Span<BoneTransform> pose)
    {
        if (values.Length is not (CalculationFrame.FullValueCount or CalculationFrame.BodyValueCount))
            throw new ArgumentException("A frame must have 946 or 338 values.", nameof(values));
        if (pose.Length < BoneHierarchy.BoneCount)
            throw new ArgumentException("There must be room for each of the 59 bones.", nameof(pose));

        var frame = new SensorFrame(values, _axes);
        Span<BoneTransform> world = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            Bone? parent = BoneHierarchy.GetParent(bone, Body.Variant);
            BoneTransform from = parent is null ? BoneTransform.Identity : world[(int)parent];
            world[(int)bone] = Place(frame, bone, from);
            pose[(int)bone] = from.ToLocal(world[(int)bone]);
            if (parent is not null && bone is not (Bone.RightFoot or Bone.LeftFoot))
                pose[(int)bone] = pose[(int)bone] with { Position = _offsets[(int)bone] };
        }

        pose[0] = pose[0] with { Position = pose[0].Position - (GroundHeight * Vector3.UnitY) };
    }

    private BoneTransform Place(in SensorFrame frame, Bone bone, BoneTransform parent)
    {
        Vector3 joint = parent.TransformPoint(_offsets[(int)bone]);
        if (CalculationOrder.IndexOf(bone) >= CalculationOrder.BodyBoneCount)
            return new BoneTransform(joint, parent.Rotation);

        Vector3 centre = frame.GetCentre(bone);
        Quaternion rotation = Quaternion.Normalize(_measurement.GetSensor(frame, bone) * _measurement.Mountings[(int)bone]);
        Vector3 half = Vector3.Transform(_measurement.Halves[(int)bone], rotation);
        if (bone is Bone.Hips or Bone.RightFoot or Bone.LeftFoot)
            return new BoneTransform(centre - half, rotation);

        return new BoneTransform(joint, Quaternion.Normalize(AxisPair.Between(half, centre - joint) * rotation));
    }

    // One value that is not a number would spread to all lengths.
    private static int[] FindFinite(CalculationDocument take, CalculationAxes axes)
    {
        int[] finite = [.. Enumerable.Range(0, take.FrameCount).Where(frame => new SensorFrame(take.GetValues(frame), axes).IsFinite)];
        int step = ((finite.Length - 1) / MaxFrames) + 1;
        return [.. finite.Where((_, place) => place % step == 0)];
    }

    private float MeasureGround(CalculationDocument take, int[] frames)
    {
        double sum = 0;
        int count = 0;
        float lowest = float.MaxValue;
        foreach (int i in frames)
        {
            var frame = new SensorFrame(take.GetValues(i), _axes);
            foreach (Bone foot in (ReadOnlySpan<Bone>)[Bone.LeftFoot, Bone.RightFoot])
            {
                Quaternion rotation = _measurement.GetSensor(frame, foot) * _measurement.Mountings[(int)foot];
                float height = (frame.GetCentre(foot) + Vector3.Transform(_measurement.Halves[(int)foot], rotation)).Y;
                lowest = Math.Min(lowest, height);
                if (foot == Bone.LeftFoot ? !frame.LeftContact : !frame.RightContact)
                    continue;

                sum += height;
                count++;
            }
        }

        return count > 0 ? (float)(sum / count) : lowest;
    }
}
