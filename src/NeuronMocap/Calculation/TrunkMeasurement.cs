using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Calculation;

/// <summary>
/// What all frames of a take together say about hips and chest: where the legs, the spine and the shoulders begin in their sensors' axes, and how
/// the two sensors sit on them. Hips: X through both hip joints; chest: Y along the spine.
/// </summary>
internal sealed class TrunkMeasurement
{
    // Half the hips' width and the default body's thigh.
    private const float HipShare = 9.5f / 37.051f;

    private readonly JointFit[] _hipJoints = [new(), new()];
    private readonly JointFit[] _shoulderJoints = [new(), new()];
    private DirectionSum _spine;
    private DirectionSum _chestUp;
    private DirectionSum _shoulderLine;
    private double _hipsToSpine;
    private double _spineToSpine1;

    /// <summary>From the hips to the thighs' joints, right and left, in the hips' sensor's axes.</summary>
    public Vector3[] HipJoints { get; } = new Vector3[2];

    /// <summary>From the chest's centre to the shoulders' joints, right and left, in the chest's sensor's axes.</summary>
    public Vector3[] ShoulderJoints { get; } = new Vector3[2];

    /// <summary>From the hips to the spine's joint, in the hips' sensor's axes.</summary>
    public Vector3 SpineJoint { get; private set; }

    /// <summary>The hips' bone axes in those of its sensor.</summary>
    public Quaternion Hips { get; private set; }

    /// <summary>The chest's bone axes in those of its sensor.</summary>
    public Quaternion Chest { get; private set; }

    /// <summary>Which of the two divisions of the spine the body has.</summary>
    public SkeletonVariant Variant { get; private set; }

    /// <summary>The bone that the shoulders hang at.</summary>
    public Bone ChestBone => Variant == SkeletonVariant.Spine3 ? Bone.Neck : Bone.Spine2;

    public void Add(in SensorFrame frame)
    {
        Vector3 hips = frame.GetCentre(Bone.Hips);
        Vector3 right = frame.GetCentre(Bone.RightUpLeg);
        Vector3 left = frame.GetCentre(Bone.LeftUpLeg);
        Quaternion hipsSensor = frame.GetRotation(Bone.Hips);

        // A guess for a take in which nobody moves: the joints lie on a line with the hips, as wide as in the default body.
        Vector3 line = left - right;
        line = line == Vector3.Zero ? Vector3.UnitX : Vector3.Normalize(line);
        float halfWidth = 2 * HipShare * ((left + right) / 2 - hips).Length();
        _hipJoints[0].Add(hipsSensor, frame.GetRotation(Bone.RightUpLeg), right - hips, line * -halfWidth);
        _hipJoints[1].Add(hipsSensor, frame.GetRotation(Bone.LeftUpLeg), left - hips, line * halfWidth);

        Vector3 spine = frame.GetCentre(Bone.Spine);
        Vector3 spine1 = frame.GetCentre(Bone.Spine1);
        _spine.Add(hipsSensor, (1.5f * spine) - (0.5f * spine1) - hips);
        _hipsToSpine += (spine - hips).Length();
        _spineToSpine1 += (spine1 - spine).Length();

        // The recordings' shoulders begin at the upper end of their bone, whichever it is.
        Vector3 spine2 = frame.GetCentre(Bone.Spine2);
        Vector3 chest = frame.GetCentre(Bone.Neck);
        Vector3 guess = (chest - spine2) / 2;
        Quaternion chestSensor = frame.GetRotation(Bone.Spine2);
        Vector3 rightShoulder = frame.GetCentre(Bone.RightShoulder);
        Vector3 leftShoulder = frame.GetCentre(Bone.LeftShoulder);
        _shoulderJoints[0].Add(chestSensor, frame.GetRotation(Bone.RightShoulder), rightShoulder - chest, guess);
        _shoulderJoints[1].Add(chestSensor, frame.GetRotation(Bone.LeftShoulder), leftShoulder - chest, guess);
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

        // From the hips to the spine's centre and on to the next one's: 18.0 and 9.3 cm in the default body with Spine3, 15.0 and 13.5 with Neck1.
        Variant = _hipsToSpine > 1.5 * _spineToSpine1 ? SkeletonVariant.Spine3 : SkeletonVariant.Neck1;
    }
}
