using System.Numerics;

namespace NeuronMocap.Calculation;

/// <summary>
/// What all frames of a take together say about one leg or arm: how long its bones are, and how the sensors sit on them. From the joint at the
/// trunk on, each next joint lies as far beyond a bone's centre as the last one lies before it. Knee and elbow bend about one axis, which says how
/// thigh, shank and arm are turned about their own length.
/// </summary>
internal sealed class LimbMeasurement(ReadOnlyMemory<Bone> bones, bool isLeg, bool isLeft)
{
    // What the trunk's axis counts against that of knee or elbow: decides where a limb is never bent.
    private const float TrunkWeight = 0.02f;

    private readonly DirectionSum[] _halves = new DirectionSum[bones.Length];
    private readonly DirectionSum[] _axes = new DirectionSum[bones.Length];
    private DirectionSum _pinnedFoot;

    /// <summary>Adds a frame.</summary>
    /// <param name="frame">The frame.</param>
    /// <param name="joint">Where the limb begins.</param>
    /// <param name="trunk">Rotation of the bone it hangs at.</param>
    public void Add(in SensorFrame frame, Vector3 joint, Quaternion trunk)
    {
        Span<Vector3> halves = stackalloc Vector3[bones.Length];
        for (int i = 0; i < bones.Length; i++)
        {
            halves[i] = frame.GetCentre(bones.Span[i]) - joint;
            joint += 2 * halves[i];
        }

        // Upper and lower of the two long bones: a leg begins with them, an arm has the shoulder before.
        int upper = isLeg ? 0 : 1;
        Vector3 hinge = Vector3.Cross(halves[upper], halves[upper + 1]) / (halves[upper].Length() * halves[upper + 1].Length() + 1e-6f);
        Vector3 axis = (isLeg || !isLeft ? hinge : -hinge) + (TrunkWeight * Vector3.Transform(isLeg ? Vector3.UnitX : Vector3.UnitY, trunk));
        for (int i = 0; i < bones.Length; i++)
        {
            Quaternion sensor = frame.GetRotation(bones.Span[i]);
            bool isShoulder = !isLeg && i == 0;
            bool isFoot = isLeg && i == bones.Length - 1;
            if (isFoot && frame.LeftContact && frame.RightContact)
                _pinnedFoot.Add(sensor, halves[i]);
            else
                _halves[i].Add(sensor, halves[i]);

            if (isFoot)
                _axes[i].Add(sensor, Vector3.UnitY * ((isLeft ? frame.LeftContact : frame.RightContact) ? 1 : TrunkWeight));
            else
                _axes[i].Add(sensor, isShoulder ? Vector3.Transform(Vector3.UnitY, trunk) : axis);
        }
    }

    /// <summary>Writes what was found.</summary>
    /// <param name="halves">From each bone's joint to its centre, in the bone's axes; by bone.</param>
    /// <param name="mountings">Each bone's axes in those of its sensor; by bone.</param>
    public void Solve(Span<Vector3> halves, Span<Quaternion> mountings)
    {
        for (int i = 0; i < bones.Length; i++)
        {
            int bone = (int)bones.Span[i];
            bool isFoot = isLeg && i == bones.Length - 1;
            Vector3 half = isFoot && _halves[i].Count == 0 ? _pinnedFoot.Mean : _halves[i].Mean;
            mountings[bone] = isFoot ? MountFoot(half, _axes[i].Sum)
                : isLeg ? AxisPair.FromY(-half, _axes[i].Sum)
                : AxisPair.FromX(isLeft ? half : -half, _axes[i].Sum);
            halves[bone] = Vector3.Transform(half, Quaternion.Conjugate(mountings[bone]));
        }
    }

    // A foot that stands has Y upwards, and its length forward.
    private static Quaternion MountFoot(Vector3 half, Vector3 up) => AxisPair.FromY(up, Vector3.Cross(up, half));
}
