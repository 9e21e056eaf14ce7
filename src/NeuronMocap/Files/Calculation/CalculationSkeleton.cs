using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Calculation;

/// <summary>
/// The skeleton behind a take of calculation data, which has bones' centres and sensors' rotations only. From how both move together it finds
/// where the joints are, how long the bones, and how the sensors sit on them, and then poses of the 59 bones. Immutable; thread-safe.
/// <para>
/// A bone is turned as its sensor says, and then by the shortest way to where its centre was recorded; only the feet, which the server holds to the ground
/// when both stand, move away from their place in the body. How near this comes to what was recorded stands in docs/guide/calculation.md. What fingers
/// do is not known: they are carried along.
/// </para>
/// </summary>
public sealed class CalculationSkeleton
{
    // More frames of a take say the same again.
    private const int MaxFrames = 2000;

    private const string EndsOfBones = "This calculation export has the ends of the bones instead of their centres: its thighs begin at the hips, without a "
        + "hip's width. No poses are made of it, for hips and sensors cannot be found. Its rows can be read and copied all the same.";

    private readonly BodyMeasurement _measurement;
    private readonly Vector3[] _offsets;
    private readonly CalculationAxes _axes;

    private CalculationSkeleton(CalculationDocument take, CalculationAxes axes)
    {
        int step = ((take.FrameCount - 1) / MaxFrames) + 1;
        _axes = axes;
        if (BonePoints.AreEnds(take, axes, step))
            throw new CalculationFormatException(EndsOfBones);

        _measurement = BodyMeasurement.Of(take, axes, step);
        _offsets = _measurement.CreateOffsets();
        Vector3[] ends = _measurement.CreateEndSites();
        Span<BoneTransform> rest = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        for (int bone = 0; bone < rest.Length; bone++)
            rest[bone] = new BoneTransform(_offsets[bone], Quaternion.Identity);

        Body = SkeletonBody.FromPose(rest, _measurement.Variant, ends);
        GroundHeight = MeasureGround(take, step);
        Warnings = BodyPlausibility.Find(_offsets);
    }

    /// <summary>The actor's sizes.</summary>
    public SkeletonBody Body { get; }

    /// <summary>
    /// Height of the ground in the take's world, whose origin is at the hips when recording began: that of the toes that stand, on the average.
    /// Poses are above a ground at zero. Centimetres.
    /// </summary>
    public float GroundHeight { get; }

    /// <summary>
    /// Lengths that nobody has, such as legs that are tens of centimetres apart, in sentences: the take's values mean something else than this library takes
    /// them for, or a sensor failed. Empty where nothing is odd.
    /// </summary>
    public IReadOnlyList<string> Warnings { get; }

    /// <summary>Finds the skeleton behind a take.</summary>
    /// <param name="take">The take. Bones that do not move in it get places as in the default body.</param>
    /// <param name="axes">The take's axes; null is the same as <see cref="CalculationAxes.Export"/>.</param>
    /// <returns>The skeleton, which does not refer to the take any more.</returns>
    /// <exception cref="CalculationFormatException">The take has the ends of the bones instead of their centres.</exception>
    public static CalculationSkeleton Measure(CalculationDocument take, CalculationAxes? axes = null)
    {
        ArgumentNullException.ThrowIfNull(take);
        return new CalculationSkeleton(take, axes ?? CalculationAxes.Export);
    }

    /// <summary>Computes the pose of a frame. Allocates nothing.</summary>
    /// <param name="values">946 or 338 values of the take, or of another one of the same actor with the same sensors, not put on again in between.</param>
    /// <param name="pose">Receives 59 transforms relative to the parent, in <see cref="Bone"/> order, in the axes of BVH; centimetres.</param>
    /// <exception cref="ArgumentException">There is another number of values, or less room.</exception>
    public void CopyLocalTransforms(ReadOnlySpan<float> values, Span<BoneTransform> pose)
    {
        if (values.Length is not (CalculationFrame.FullValueCount or CalculationFrame.BodyValueCount))
            throw new ArgumentException("A frame has 946 values or 338.", nameof(values));
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

    private float MeasureGround(CalculationDocument take, int step)
    {
        double sum = 0;
        int count = 0;
        float lowest = float.MaxValue;
        for (int i = 0; i < take.FrameCount; i += step)
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
