using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Calculation;

/// <summary>
/// Measures the body of a take, and how the sensors are mounted on it, in three passes over the frames. Centres and sensor rotations are recorded;
/// joints, lengths and rotations of the bones are not. See docs/guide/calculation.md.
/// </summary>
internal sealed class BodyMeasurement
{
    private const int Bones = BoneHierarchy.BoneCount;

    private static readonly Bone[] SpineBones = [Bone.Spine, Bone.Spine1, Bone.Spine2, Bone.Neck, Bone.Neck1, Bone.Head];

    private static readonly Bone[][] LimbBones =
    [
        [Bone.RightUpLeg, Bone.RightLeg, Bone.RightFoot],
        [Bone.LeftUpLeg, Bone.LeftLeg, Bone.LeftFoot],
        [Bone.RightShoulder, Bone.RightArm, Bone.RightForeArm, Bone.RightHand],
        [Bone.LeftShoulder, Bone.LeftArm, Bone.LeftForeArm, Bone.LeftHand],
    ];

    private readonly TrunkMeasurement _trunk;
    private readonly LimbMeasurement[] _limbs = [.. LimbBones.Select((bones, limb) => new LimbMeasurement(bones, limb < 2, limb % 2 == 1))];
    private readonly DirectionSum[] _spine = new DirectionSum[SpineBones.Length];
    private readonly DirectionSum[] _shoulders = new DirectionSum[2];
    private readonly DirectionSum[] _spineAxes = new DirectionSum[SpineBones.Length];

    private BodyMeasurement(SkeletonVariant variant)
    {
        _trunk = new TrunkMeasurement(variant);
        Mountings.AsSpan().Fill(Quaternion.Identity);
    }

    /// <summary>The vectors from each bone's joint to its centre, in the axes of the bone; by bone.</summary>
    public Vector3[] Halves { get; } = new Vector3[Bones];

    /// <summary>The axes of each bone in those of its sensor; by bone.</summary>
    public Quaternion[] Mountings { get; } = new Quaternion[Bones];

    public SkeletonVariant Variant => _trunk.Variant;

    /// <param name="take">The take.</param>
    /// <param name="axes">Its axes.</param>
    /// <param name="frames">The frames to measure; at least one. All their centres are finite.</param>
    public static BodyMeasurement Of(CalculationDocument take, CalculationAxes axes, int[] frames)
    {
        var body = new BodyMeasurement(TrunkMeasurement.Recognize(new SensorFrame(take.GetValues(frames[0]), axes)));
        foreach (int frame in frames)
            body._trunk.Add(new SensorFrame(take.GetValues(frame), axes));

        body.SolveTrunk();
        foreach (int frame in frames)
            body.AddLimbs(new SensorFrame(take.GetValues(frame), axes));

        body.SolveLimbs();
        foreach (int frame in frames)
            body.AddShoulders(new SensorFrame(take.GetValues(frame), axes));

        return body;
    }

    /// <summary>
    /// Gets the rotation that represents the sensor of a bone. Most bones have their own sensor. The spine bends evenly between hips and chest, so
    /// its bones have a rotation between those two.
    /// </summary>
    public Quaternion GetSensor(in SensorFrame frame, Bone bone)
    {
        float share = bone switch
        {
            Bone.Spine => 0.25f,
            Bone.Spine1 => 0.5f,
            Bone.Spine2 => Variant == SkeletonVariant.Spine3 ? 0.75f : 1,
            Bone.Neck => Variant == SkeletonVariant.Spine3 ? 1 : -1,
            _ => -1,
        };
        if (share < 0)
            return frame.GetRotation(bone);

        Quaternion chest = frame.GetRotation(Bone.Spine2) * _trunk.Chest;
        return share == 1 ? chest : Quaternion.Slerp(frame.GetRotation(Bone.Hips) * _trunk.Hips, chest, share);
    }

    /// <summary>Creates the positions of the bones relative to their parents in the rest pose, except for the hips; by bone.</summary>
    public Vector3[] CreateOffsets()
    {
        var offsets = new Vector3[Bones];
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            if (BoneHierarchy.GetParent(bone, Variant) is { } parent)
                offsets[(int)bone] = CalculationOrder.IndexOf(bone) < CalculationOrder.BodyBoneCount ? 2 * Halves[(int)parent] : ScaleFinger(bone, DefaultOffsets.Get(bone));
        }

        Quaternion hips = Quaternion.Conjugate(_trunk.Hips);
        offsets[(int)Bone.RightUpLeg] = Vector3.Transform(_trunk.HipJoints[0], hips);
        offsets[(int)Bone.LeftUpLeg] = Vector3.Transform(_trunk.HipJoints[1], hips);
        offsets[(int)Bone.Spine] = Vector3.Transform(_trunk.SpineJoint, hips);
        offsets[(int)Bone.RightShoulder] = _shoulders[0].Mean;
        offsets[(int)Bone.LeftShoulder] = _shoulders[1].Mean;
        return offsets;
    }

    /// <summary>Creates the ends of the bones without children; by bone.</summary>
    public Vector3[] CreateEndSites()
    {
        var ends = new Vector3[Bones];
        foreach (Bone bone in JointPositions.EndSiteBones)
        {
            DefaultOffsets.TryGetEndSite(bone, out Vector3 end);
            ends[(int)bone] = CalculationOrder.IndexOf(bone) < CalculationOrder.BodyBoneCount ? 2 * Halves[(int)bone] : ScaleFinger(bone, end);
        }

        return ends;
    }

    // Without gloves, fingers are not recorded. They receive the proportions of the default hand, scaled to the actor. Without fingers, a recorded
    // hand reaches to its fingertips; with fingers, the hand ends where the middle finger begins.
    private Vector3 ScaleFinger(Bone bone, Vector3 offset)
    {
        const float DefaultPalm = 3.4f;
        const float DefaultHand = 3.3f + 5.0f + 3.8f + 2.4f + 1.9f;
        Bone hand = bone < Bone.LeftShoulder ? Bone.RightHand : Bone.LeftHand;
        float length = 2 * Halves[(int)hand].Length();
        return length == 0 ? offset : offset * (length / (length < DefaultHand / 2 ? DefaultPalm : DefaultHand));
    }

    private void SolveTrunk()
    {
        _trunk.Solve();
        Mountings[(int)Bone.Hips] = _trunk.Hips;
    }

    private void AddLimbs(in SensorFrame frame)
    {
        Vector3 hips = frame.GetCentre(Bone.Hips);
        Quaternion hipsSensor = frame.GetRotation(Bone.Hips);
        Quaternion chestSensor = frame.GetRotation(Bone.Spine2);
        for (int side = 0; side < 2; side++)
        {
            _limbs[side].Add(frame, hips + Vector3.Transform(_trunk.HipJoints[side], hipsSensor), hipsSensor * _trunk.Hips);
            Vector3 shoulder = frame.GetCentre(_trunk.ChestBone) + Vector3.Transform(_trunk.ShoulderJoints[side], chestSensor);
            _limbs[2 + side].Add(frame, shoulder, chestSensor * _trunk.Chest);
        }

        Vector3 joint = hips + Vector3.Transform(_trunk.SpineJoint, hipsSensor);
        for (int i = 0; i < SpineBones.Length; i++)
        {
            Vector3 centre = frame.GetCentre(SpineBones[i]);
            Quaternion sensor = GetSensor(frame, SpineBones[i]);
            _spine[i].Add(sensor, centre - joint);
            _spineAxes[i].Add(sensor, Vector3.Transform(Vector3.UnitX, chestSensor * _trunk.Chest));
            joint = i < SpineBones.Length - 2 ? (centre + frame.GetCentre(SpineBones[i + 1])) / 2 : (2 * centre) - joint;
        }
    }

    private void SolveLimbs()
    {
        foreach (LimbMeasurement limb in _limbs)
            limb.Solve(Halves, Mountings);

        for (int i = 0; i < SpineBones.Length; i++)
        {
            // On average, the spine, the neck and the head are not turned to a side.
            int bone = (int)SpineBones[i];
            Vector3 half = _spine[i].Mean;
            Mountings[bone] = AxisPair.FromY(half, _spineAxes[i].Sum);
            Halves[bone] = Vector3.Transform(half, Quaternion.Conjugate(Mountings[bone]));
        }
    }

    private void AddShoulders(in SensorFrame frame)
    {
        Bone bone = _trunk.ChestBone;
        Vector3 centre = frame.GetCentre(bone);
        Quaternion rotation = GetSensor(frame, bone) * Mountings[(int)bone];
        Vector3 joint = centre - Vector3.Transform(Halves[(int)bone], rotation);
        for (int side = 0; side < 2; side++)
        {
            Vector3 shoulder = frame.GetCentre(_trunk.ChestBone) + Vector3.Transform(_trunk.ShoulderJoints[side], frame.GetRotation(Bone.Spine2));
            _shoulders[side].Add(rotation, shoulder - joint);
        }
    }
}
