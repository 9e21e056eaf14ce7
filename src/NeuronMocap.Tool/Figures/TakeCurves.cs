using System.Numerics;
using NeuronMocap.Motion;

namespace NeuronMocap.Tool.Figures;

/// <summary>The data of the charts and the map, from one pass through the take. Its size does not depend on the length of the take.</summary>
internal sealed class TakeCurves
{
    private const int Stretches = 540;
    private const int LongestTrail = 2000;
    private const float Slack = 10; // cm
    private const float SlackOfUnknownUnit = 0.05f; // of the height of the first pose

    private readonly WalkingDistance _walk;

    private TakeCurves(PointMotion motion)
    {
        _walk = new WalkingDistance(motion.IsInCentimetres ? Slack : Math.Max(1e-6f, FirstHeight(motion) * SlackOfUnknownUnit));
        LeftFoot = new Curve(motion.FrameCount, Stretches);
        RightFoot = new Curve(motion.FrameCount, Stretches);
        Root = new Curve(motion.FrameCount, Stretches);
        LeftHand = new Curve(motion.FrameCount, Stretches);
        RightHand = new Curve(motion.FrameCount, Stretches);
    }

    /// <summary>Height of the lowest point of the foot in the world.</summary>
    public Curve LeftFoot { get; }

    public Curve RightFoot { get; }

    /// <summary>Horizontal speed of the hips.</summary>
    public Curve Root { get; }

    /// <summary>Speed of the hand.</summary>
    public Curve LeftHand { get; }

    public Curve RightHand { get; }

    /// <summary>Height of the ground: the lowest point of any foot. If feet are unknown, the lowest point of the body.</summary>
    public float Ground { get; private set; } = float.NaN;

    /// <summary>Contacts of the left foot; null if contacts are unknown.</summary>
    public ContactTrack? LeftContacts { get; private set; }

    public ContactTrack? RightContacts { get; private set; }

    /// <summary>The lowest X, Y and Z of the hips.</summary>
    public Vector3 Lowest { get; private set; } = new(float.PositiveInfinity);

    /// <summary>The highest X, Y and Z of the hips.</summary>
    public Vector3 Highest { get; private set; } = new(float.NegativeInfinity);

    /// <summary>Length of the path of the hips over the ground, without the sway of a standing person: see <see cref="WalkingDistance"/>.</summary>
    public double Distance => _walk.Distance;

    /// <summary>Positions of the hips at regular times.</summary>
    public List<Vector3> Trail { get; } = [];

    /// <summary>Measures a take.</summary>
    /// <param name="motion">The take.</param>
    /// <param name="progress">Receives progress, 0 to 1.</param>
    /// <param name="cancellationToken">Cancels the work.</param>
    /// <exception cref="OperationCanceledException">The work was cancelled.</exception>
    public static TakeCurves Measure(PointMotion motion, IProgress<double> progress, CancellationToken cancellationToken)
    {
        var curves = new TakeCurves(motion);
        curves.Walk(motion, progress, cancellationToken);
        return curves;
    }

    private void Walk(PointMotion motion, IProgress<double> progress, CancellationToken cancellationToken)
    {
        PointRoles roles = motion.Roles;
        Vector3[] points = new Vector3[motion.PointCount];
        var root = new SpeedMeter(motion.FrameRate, horizontal: true);
        var leftHand = new SpeedMeter(motion.FrameRate, horizontal: false);
        var rightHand = new SpeedMeter(motion.FrameRate, horizontal: false);
        long trailStep = Math.Max(1, motion.FrameCount / LongestTrail);
        for (long frame = 0; frame < motion.FrameCount; frame++)
        {
            cancellationToken.ThrowIfCancellationRequested();
            motion.GetPoints(frame, points);
            AddPlace(points[roles.Root], frame / motion.FrameRate);
            AddFeet(frame, motion, points);
            Add(Root, root.Add(points[roles.Root]));
            if (roles.LeftHand is { } left)
                Add(LeftHand, leftHand.Add(points[left]));
            if (roles.RightHand is { } right)
                Add(RightHand, rightHand.Add(points[right]));
            if (frame % trailStep == 0 || frame == motion.FrameCount - 1)
                Trail.Add(points[roles.Root]);

            progress.Report((double)frame / motion.FrameCount);
        }
    }

    private void AddPlace(Vector3 place, double seconds)
    {
        if (!SampledPose.IsFinite(place))
            return;

        (Lowest, Highest) = (Vector3.Min(Lowest, place), Vector3.Max(Highest, place));
        _walk.Update(place, seconds);
    }

    private void AddFeet(long frame, PointMotion motion, Vector3[] points)
    {
        PointRoles roles = motion.Roles;
        if (!roles.HasFeet)
        {
            Ground = Lower(Ground, points.Min(static point => point.Y));
            return;
        }

        Vector3 left = LowestOf(roles.LeftFoot, points);
        Vector3 right = LowestOf(roles.RightFoot, points);
        LeftFoot.Add(frame, left.Y);
        RightFoot.Add(frame, right.Y);
        Ground = Lower(Ground, Lower(left.Y, right.Y));
        if (motion.GetContacts(frame) is not { } contacts)
            return;

        (LeftContacts ??= new ContactTrack()).Add(frame, contacts.Left, points[roles.LeftFoot[0]]);
        (RightContacts ??= new ContactTrack()).Add(frame, contacts.Right, points[roles.RightFoot[0]]);
    }

    private static void Add(Curve curve, (long Frame, float Speed)? value)
    {
        if (value is { } known)
            curve.Add(known.Frame, known.Speed);
    }

    private static float FirstHeight(PointMotion motion)
    {
        Vector3[] points = new Vector3[motion.PointCount];
        motion.GetPoints(0, points);
        float height = points.Max(static point => point.Y) - points.Min(static point => point.Y);
        return float.IsFinite(height) ? height : 0;
    }

    private static Vector3 LowestOf(IReadOnlyList<int> foot, Vector3[] points)
    {
        Vector3 lowest = points[foot[0]];
        foreach (int point in foot)
        {
            if (points[point].Y < lowest.Y)
                lowest = points[point];
        }

        return lowest;
    }

    // Ignores values that are not finite.
    private static float Lower(float a, float b) => !float.IsFinite(a) ? b : !float.IsFinite(b) || a <= b ? a : b;
}
