using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

/// <summary>A performance on a rig with and without foot planting: the positions of the ankles, frame by frame.</summary>
internal sealed class FootWalk
{
    /// <summary>The distance that a planted foot may move, half a millimetre, because of rounding.</summary>
    public const float Still = 0.0005f;

    private readonly List<FootContacts> _contacts = [];
    private readonly List<FootContacts> _held = [];
    private readonly List<Vector3>[] _planted = [[], []];
    private readonly List<Vector3>[] _free = [[], []];
    private readonly Track[] _knees = [new(), new()];
    private readonly Track[] _soles = [new(), new()];
    private readonly double _rate;
    private readonly int[] _feet;

    public FootWalk(TargetRig rig, SkeletonBody body, double rate, RetargetOptions? options = null, FootPlanterOptions? planting = null)
    {
        (Rig, _rate) = (rig, rate);
        Retargeter = new Retargeter(rig, body, options);
        Planter = new FootPlanter(rig, planting);
        Pose = new RetargetedPose(rig);
        _feet = [rig.GetNode(HumanoidBone.LeftFoot), rig.GetNode(HumanoidBone.RightFoot)];
    }

    public TargetRig Rig { get; }

    public Retargeter Retargeter { get; }

    public FootPlanter Planter { get; }

    public RetargetedPose Pose { get; }

    public int Count => _contacts.Count;

    public float MaxHipsShift { get; private set; }

    /// <summary>The least distance of a knee in front of the line from hip to ankle, in metres. Negative values are behind it.</summary>
    public float LeastKnee { get; private set; } = float.PositiveInfinity;

    public int FramesLetGo { get; private set; }

    /// <summary>The largest increase of a knee's speed by planting, in metres a second.</summary>
    public float LargestKneeSpeed { get; private set; }

    /// <summary>The largest increase of a foot's turning speed by planting, in degrees a second.</summary>
    public float LargestTurn { get; private set; }

    public static FootWalk OfActor(TargetRig rig, double rate, double seconds, int avatar = 0, RetargetOptions? options = null, FootPlanterOptions? planting = null, Vector3 drift = default)
    {
        var walk = new FootWalk(rig, SkeletonBody.GetDefault(), rate, options, planting);
        var actor = new SyntheticSource(rate, avatar);
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        for (int frame = 0; frame < seconds * rate; frame++)
        {
            actor.GetPose(frame, pose);
            pose[0] = pose[0] with { Position = pose[0].Position + (drift * (float)(frame / rate)) };
            walk.Add(pose, actor.GetFootContacts(frame));
        }

        return walk;
    }

    public void Add(ReadOnlySpan<BoneTransform> pose, FootContacts contacts)
    {
        Assert.True(Retargeter.TryRetarget(pose, Pose));
        Pose.UpdateWorld();
        for (int side = 0; side < 2; side++)
        {
            _free[side].Add(Pose.WorldPositions[_feet[side]]);
            _knees[side].Free = Pose.WorldPositions[KneeNode(side)];
            _soles[side].Free = TipOf(side);
        }

        Planter.Plant(Pose, contacts, Count / _rate);

        // From the values that are written to the transforms.
        Pose.UpdateWorld();
        for (int side = 0; side < 2; side++)
        {
            _planted[side].Add(Pose.WorldPositions[_feet[side]]);
            LeastKnee = Math.Min(LeastKnee, Knee(side));
            LargestKneeSpeed = Math.Max(LargestKneeSpeed, _knees[side].Add(Pose.WorldPositions[KneeNode(side)]) * (float)_rate);
            LargestTurn = Math.Max(LargestTurn, _soles[side].Add(TipOf(side)) * (float)_rate * 180 / MathF.PI);
        }

        _contacts.Add(contacts);
        _held.Add(Planter.Planted);
        MaxHipsShift = Math.Max(MaxHipsShift, Math.Abs(Planter.HipsShift));
        if (contacts != Planter.Planted)
            FramesLetGo++;
    }

    public Vector3 Ankle(int side, int frame) => _planted[side][frame];

    public Vector3 FreeAnkle(int side, int frame) => _free[side][frame];

    /// <summary>The largest horizontal movement of a foot within a contact. For a planted foot, until its release.</summary>
    public float LargestSlide(bool planted) => Contacts(planted).Select(contact => Spread(contact, planted, new Vector3(1, 0, 1), 0)).DefaultIfEmpty().Max();

    /// <summary>The largest movement of a foot in any direction within a contact, from a time after its start.</summary>
    public float LargestMove(bool planted, double after) =>
        Contacts(planted).Select(contact => Spread(contact, planted, Vector3.One, (int)Math.Ceiling(after * _rate))).DefaultIfEmpty().Max();

    /// <summary>The largest increase of a foot's movement between frames by planting, as a speed.</summary>
    public float LargestAddedSpeed()
    {
        float largest = 0;
        for (int side = 0; side < 2; side++)
        {
            for (int frame = 1; frame < Count; frame++)
            {
                float step = Vector3.Distance(_planted[side][frame], _planted[side][frame - 1]);
                float free = Vector3.Distance(_free[side][frame], _free[side][frame - 1]);
                largest = Math.Max(largest, (step - free) * (float)_rate);
            }
        }

        return largest;
    }

    public float LargestDistance(FootWalk other, int stride) => Enumerable.Range(0, 2)
        .SelectMany(side => Enumerable.Range(0, Count).Where(frame => frame * stride < other.Count)
            .Select(frame => Vector3.Distance(_planted[side][frame], other._planted[side][frame * stride])))
        .Max();

    /// <summary>All figures in a line, for the output and for assertion messages.</summary>
    public string Describe(string name)
    {
        string figures = FormattableString.Invariant(
            $"{name}: slides {LargestSlide(planted: false) * 1000:0.0} mm, planted {LargestSlide(planted: true) * 1000:0.000}, settled {LargestMove(planted: true, 0.1) * 1000:0.000}; hips {MaxHipsShift * 1000:0} mm of leg {Rig.LegLength:0.00}; knee {LeastKnee * 1000:0.00}; added {LargestAddedSpeed():0.00} m/s, knee {LargestKneeSpeed:0.00} m/s, {LargestTurn:0} degrees/s; let go {FramesLetGo}");
        TestContext.Current.TestOutputHelper?.WriteLine(figures);
        return figures;
    }

    private IEnumerable<(int Side, int First, int End)> Contacts(bool planted)
    {
        List<FootContacts> contacts = planted ? _held : _contacts;
        for (int side = 0; side < 2; side++)
        {
            int first = -1;
            for (int frame = 0; frame <= Count; frame++)
            {
                bool stands = frame < Count && (side == 0 ? contacts[frame].Left : contacts[frame].Right);
                if (stands && first < 0)
                    first = frame;
                if (stands || first < 0)
                    continue;

                yield return (side, first, frame);
                first = -1;
            }
        }
    }

    private float Spread((int Side, int First, int End) contact, bool planted, Vector3 axes, int skipped)
    {
        List<Vector3> way = (planted ? _planted : _free)[contact.Side];
        float largest = 0;
        for (int frame = contact.First + skipped + 1; frame < contact.End; frame++)
            largest = Math.Max(largest, ((way[frame] - way[contact.First + skipped]) * axes).Length());

        return largest;
    }

    private int KneeNode(int side) => Rig.GetNode(HumanoidBone.LeftLowerLeg + side);

    // A point that moves when the foot turns.
    private Vector3 TipOf(int side) =>
        Vector3.Transform(Vector3.UnitZ, Pose.WorldRotations[_feet[side]] * Quaternion.Conjugate(Rig.RestRotations[_feet[side]]));

    private float Knee(int side)
    {
        int thigh = Rig.GetNode(HumanoidBone.LeftUpperLeg + side);
        ReadOnlySpan<Vector3> at = Pose.WorldPositions;
        Vector3 hip = at[thigh];
        Vector3 axis = Vector3.Normalize(at[_feet[side]] - hip);
        Vector3 knee = at[KneeNode(side)] - hip;
        Vector3 ahead = Vector3.Transform(Vector3.Transform(Vector3.UnitZ, Rig.Facing), Pose.WorldRotations[thigh] * Quaternion.Conjugate(Rig.RestRotations[thigh]));
        ahead -= axis * Vector3.Dot(ahead, axis);
        return Vector3.Dot(knee, Vector3.Normalize(ahead));
    }

    // The positions of a point with and without planting, and the added movement from one frame to the next.
    private sealed class Track
    {
        private (Vector3 Planted, Vector3 Free)? _last;

        public Vector3 Free { get; set; }

        public float Add(Vector3 planted)
        {
            float more = _last is { } last ? Vector3.Distance(planted, last.Planted) - Vector3.Distance(Free, last.Free) : 0;
            _last = (planted, Free);
            return more;
        }
    }
}
