using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Calculation;

/// <summary>
/// Measures hips and chest from all frames of a take. It finds where the legs, the spine and the shoulders begin in the axes of the
/// sensors, and how the two sensors are mounted. The X axis of the hips goes through both hip joints; the Y axis of the chest goes along
/// the spine.
/// </summary>
internal sealed class TrunkMeasurement(SkeletonVariant variant)
{
    // Half the hip width divided by the thigh length, in the default body.
    private const float HipShare = 9.5f / 37.051f;

    // Hips move enough on their own. Recorded knees would only add their error.
    private static readonly Bone[][] Legs = [[Bone.RightUpLeg], [Bone.LeftUpLeg]];

    private static readonly Bone[][] Arms =
        [[Bone.RightShoulder, Bone.RightArm, Bone.RightForeArm], [Bone.LeftShoulder, Bone.LeftArm, Bone.LeftForeArm]];

    private readonly ChainFit[] _hipJoints = [new(2), new(2)];
    private readonly ChainFit[] _shoulderJoints = [new(4), new(4)];
    private DirectionSum _spine;
    private DirectionSum _chestUp;
    private DirectionSum _shoulderLine;

    /// <summary>The vectors from the hips to the thigh joints, right and left, in the axes of the hip sensor.</summary>
    public Vector3[] HipJoints { get; } = new Vector3[2];

    /// <summary>The vectors from the chest's centre to the shoulder joints, right and left, in the axes of the chest sensor.</summary>
    public Vector3[] ShoulderJoints { get; } = new Vector3[2];

    /// <summary>The vector from the hips to the spine joint, in the axes of the hip sensor.</summary>
    public Vector3 SpineJoint { get; private set; }

    /// <summary>The axes of the hips in those of the hip sensor.</summary>
    public Quaternion Hips { get; private set; }

    /// <summary>The axes of the chest in those of the chest sensor.</summary>
    public Quaternion Chest { get; private set; }

    /// <summary>The division of the spine that the body has.</summary>
    public SkeletonVariant Variant => variant;

    /// <summary>The bone that the shoulders are attached to.</summary>
    public Bone ChestBone { get; } = variant == SkeletonVariant.Spine3 ? Bone.Neck : Bone.Spine2;

    /// <summary>
    /// Determines the division of the spine from a frame.
    /// </summary>
    /// <remarks>
    /// The distances are those from the hips to the spine's centre, and from there to the next centre. In the default body, they are 18.0 and 9.3
    /// cm with Spine3, and 15.0 and 13.5 cm with Neck1. The actors of the recordings have 19.1 and 9.9 cm.
    /// </remarks>
    public static SkeletonVariant Recognize(in SensorFrame frame)
    {
        Vector3 spine = frame.GetCentre(Bone.Spine);
        float first = (spine - frame.GetCentre(Bone.Hips)).Length();
        float second = (frame.GetCentre(Bone.Spine1) - spine).Length();
        return first > 1.5f * second ? SkeletonVariant.Spine3 : SkeletonVariant.Neck1;
    }

    public void Add(in SensorFrame frame)
    {
        Vector3 hips = frame.GetCentre(Bone.Hips);
        Vector3 right = frame.GetCentre(Bone.RightUpLeg);
        Vector3 left = frame.GetCentre(Bone.LeftUpLeg);
        Quaternion hipsSensor = frame.GetRotation(Bone.Hips);

        // A guess for a take without motion: the joints are on a line through the hips, as wide as in the default body.
        Vector3 line = left - right;
        line = line == Vector3.Zero ? Vector3.UnitX : Vector3.Normalize(line);
        float halfWidth = 2 * HipShare * ((left + right) / 2 - hips).Length();
        Add(_hipJoints[0], frame, hipsSensor, hips, Legs[0], line * -halfWidth);
        Add(_hipJoints[1], frame, hipsSensor, hips, Legs[1], line * halfWidth);

        Vector3 spine = frame.GetCentre(Bone.Spine);
        Vector3 spine1 = frame.GetCentre(Bone.Spine1);
        _spine.Add(hipsSensor, (1.5f * spine) - (0.5f * spine1) - hips);

        Vector3 chest = frame.GetCentre(ChestBone);
        Vector3 below = frame.GetCentre(ChestBone - 1);
        Quaternion chestSensor = frame.GetRotation(Bone.Spine2);
        Vector3 rightShoulder = frame.GetCentre(Bone.RightShoulder);
        Vector3 leftShoulder = frame.GetCentre(Bone.LeftShoulder);
        (Vector3 height, Vector3 width) = GuessShoulders(chest - below, leftShoulder - rightShoulder);
        Add(_shoulderJoints[0], frame, chestSensor, chest, Arms[0], height - width);
        Add(_shoulderJoints[1], frame, chestSensor, chest, Arms[1], height + width);
        _chestUp.Add(chestSensor, chest - spine1);
        _shoulderLine.Add(chestSensor, leftShoulder - rightShoulder);
    }

    public void Solve()
    {
        for (int side = 0; side < 2; side++)
        {
            HipJoints[side] = _hipJoints[side].Solve();
            ShoulderJoints[side] = _shoulderJoints[side].Solve();
        }

        SpineJoint = _spine.Mean;
        Hips = AxisPair.FromX(HipJoints[1] - HipJoints[0], SpineJoint);
        Chest = AxisPair.FromY(_chestUp.Sum, _shoulderLine.Sum);
    }

    private static void Add(ChainFit fit, in SensorFrame frame, Quaternion sensor, Vector3 point, ReadOnlySpan<Bone> limb, Vector3 guess)
    {
        Span<Quaternion> rotations = stackalloc Quaternion[limb.Length + 1];
        Span<Vector3> centres = stackalloc Vector3[limb.Length + 1];
        (rotations[0], centres[0]) = (sensor, point);
        for (int i = 0; i < limb.Length; i++)
            (rotations[i + 1], centres[i + 1]) = (frame.GetRotation(limb[i]), frame.GetCentre(limb[i]));

        fit.Add(rotations, centres, guess);
    }

    // The assumed start of the shoulders. In the recordings, it is the upper end of the chest. With Neck1, the values come from the default body.
    // There, the chest's centre is 14.025 cm above that of the bone below. The shoulder joints are 3.315 cm above the chest's centre and 2.55 cm to
    // the sides. The shoulders' centres are 16.55 cm apart.
    private (Vector3 Height, Vector3 Width) GuessShoulders(Vector3 up, Vector3 line) => variant == SkeletonVariant.Spine3
        ? (up / 2, Vector3.Zero)
        : (up * (3.315f / 14.025f), line * (2.55f / 16.55f));
}
