using System.Numerics;

namespace NeuronMocap.Calculation;

/// <summary>
/// Measures one leg or arm from all frames of a take: the lengths of its bones, and how the sensors are mounted on them.
/// </summary>
/// <remarks>
/// The first joint is at the trunk. Each bone's centre is the midpoint of its two joints, which gives the next joint. Knee and elbow bend about one
/// axis. This axis shows how thigh, shank and arm are turned about their own length.
/// </remarks>
internal sealed class LimbMeasurement(ReadOnlyMemory<Bone> bones, bool isLeg, bool isLeft)
{
    // Weight of the trunk's axis relative to that of knee or elbow. It decides only if the limb never bends.
    private const float TrunkWeight = 0.02f;

    private readonly DirectionSum[] _halves = new DirectionSum[bones.Length];
    private readonly DirectionSum[] _axes = new DirectionSum[bones.Length];
    private DirectionSum _pinnedFoot;

    /// <summary>Adds a frame.</summary>
    /// <param name="frame">The frame.</param>
    /// <param name="joint">The first joint of the limb.</param>
    /// <param name="trunk">Rotation of the trunk bone that the limb is attached to.</param>
    public void Add(in SensorFrame frame, Vector3 joint, Quaternion trunk)
    {
        Span<Vector3> halves = stackalloc Vector3[bones.Length];
        for (int i = 0; i < bones.Length; i++)
        {
            halves[i] = frame.GetCentre(bones.Span[i]) - joint;
            joint += 2 * halves[i];
        }

        // Upper and lower long bone. They are the first bones of a leg; in an arm, the shoulder precedes them.
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

    /// <summary>Writes the results.</summary>
    /// <param name="halves">The vectors from each bone's joint to its centre, in the axes of the bone; by bone.</param>
    /// <param name="mountings">The axes of each bone in those of its sensor; by bone.</param>
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

    // For a standing foot, Y points up and its length points forward.
    private static Quaternion MountFoot(Vector3 half, Vector3 up) => AxisPair.FromY(up, Vector3.Cross(up, half));
}
