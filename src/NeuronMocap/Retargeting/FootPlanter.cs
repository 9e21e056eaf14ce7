namespace NeuronMocap.Retargeting;

/// <summary>
/// Holds a character's feet where they touch the ground. Other proportions than the actor's, and the drift of inertial sensors, make feet slide;
/// here a foot keeps its place from the first frame of a contact to the last, and the leg is bent to fit. Works on a retargeted pose, in the
/// character's root: not for <see cref="RootMotion.InPlace"/>, where feet are meant to slide. Knees that noise bends backwards are bent forward.
/// Allocates nothing for a frame, works the same at any frame rate. Not thread-safe.
/// </summary>
public sealed class FootPlanter
{
    /// <summary>A longer time between two frames, in seconds, forward or back, is a break: what was held is forgotten.</summary>
    public const double MaxGap = 1;

    // How long the hips take to go most of the way to the height at which the feet stand: longer than a blend, shorter than a few steps.
    private const double HipsSeconds = 0.3;

    private readonly FootHold? _left;
    private readonly FootHold? _right;
    private readonly SoleHeightFilter _ground = new();
    private double _time = double.NaN;
    private float _height;
    private float? _givenGround;

    /// <summary>Makes a planter for a character.</summary>
    /// <param name="rig">The character. A leg whose thigh, shin and foot do not hang from each other is left alone.</param>
    /// <param name="options">Null: the defaults.</param>
    public FootPlanter(TargetRig rig, FootPlanterOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(rig);
        Rig = rig;
        Options = options ?? new FootPlanterOptions();
        _left = CreateHold(HumanoidBone.LeftUpperLeg, HumanoidBone.LeftLowerLeg, HumanoidBone.LeftFoot);
        _right = CreateHold(HumanoidBone.RightUpperLeg, HumanoidBone.RightLowerLeg, HumanoidBone.RightFoot);
    }

    /// <summary>The character.</summary>
    public TargetRig Rig { get; }

    /// <summary>Read for each frame.</summary>
    public FootPlanterOptions Options { get; }

    /// <summary>Which feet are held in the newest frame: those in contact, but for one that the leg cannot reach any more.</summary>
    public FootContacts Planted => new(_left is { IsHeld: true }, _right is { IsHeld: true });

    /// <summary>How far the hips are moved up in the newest frame, in metres of the character's root; negative: down.</summary>
    public float HipsShift { get; private set; }

    private float LargestShift => Options.MaxHipsShift * Rig.LegLength;

    /// <summary>Corrects hips, legs and feet of a pose.</summary>
    /// <param name="pose">What the retargeter made of the frame; its world is up to date afterwards. Legs that are not driven are left alone.</param>
    /// <param name="contacts">Which of the actor's feet stand: from calculation data, or estimated.</param>
    /// <param name="seconds">
    /// When the frame is, on any clock. One that is no later than the frame before counts as the same moment; further back than
    /// <see cref="MaxGap"/>, as where a take begins again, it is a break.
    /// </param>
    /// <exception cref="ArgumentException">The pose is of another rig.</exception>
    public void Plant(RetargetedPose pose, FootContacts contacts, double seconds)
    {
        ArgumentNullException.ThrowIfNull(pose);
        if (pose.Rig != Rig)
            throw new ArgumentException("The pose is of another rig.", nameof(pose));

        pose.UpdateWorld();
        bool movesHips = pose.IsDriven(Rig.HipsNode);
        double elapsed = Elapse(seconds, out bool isFirst);
        FootHold? left = Ready(_left, pose);
        FootHold? right = Ready(_right, pose);
        float ground = Options.GroundHeight ?? _ground.Update(Math.Min(SoleOf(left), SoleOf(right)), elapsed);

        // At once in the first frame, which nothing comes before; later little by little.
        if (isFirst)
            Learn(contacts.Left ? left?.GetRise(ground) : null, contacts.Right ? right?.GetRise(ground) : null, double.PositiveInfinity);
        if (!movesHips)
            _height = 0;

        float lift = (Options.GroundHeight - _givenGround) ?? 0;
        _givenGround = Options.GroundHeight;
        left?.Lift(lift, ground);
        right?.Lift(lift, ground);
        left?.Step(contacts.Left, elapsed, ground, _height, Options);
        right?.Step(contacts.Right, elapsed, ground, _height, Options);
        HipsShift = movesHips ? Math.Max(_height - Math.Max(LoweringOf(left), LoweringOf(right)), -LargestShift) : 0;
        if (HipsShift != 0)
            pose.SetHipsWorldPosition(pose.WorldPositions[Rig.HipsNode] + (Rig.Up * HipsShift));

        left?.Solve(pose, _height, Options);
        right?.Solve(pose, _height, Options);
        Learn(left?.Rise, right?.Rise, elapsed);
    }

    /// <summary>Forgets what is held: before another take, or after the character was put elsewhere.</summary>
    public void Reset()
    {
        _left?.Reset();
        _right?.Reset();
        _ground.Reset();
        _time = double.NaN;
        _height = 0;
        HipsShift = 0;
    }

    private static FootHold? Ready(FootHold? hold, RetargetedPose pose)
    {
        hold?.Leg.Measure(pose);
        if (hold is null or { Leg.IsReady: true })
            return hold;

        hold.Reset();
        return null;
    }

    private static float SoleOf(FootHold? hold) => hold?.Leg.SoleHeight ?? float.PositiveInfinity;

    private float LoweringOf(FootHold? hold) => hold?.Leg.LoweringFor(hold.Target, _height) ?? 0;

    private double Elapse(double seconds, out bool isFirst)
    {
        double elapsed = seconds - _time;
        isFirst = !(Math.Abs(elapsed) <= MaxGap);
        if (isFirst)
            Reset();
        if (isFirst || elapsed > 0)
            _time = seconds;

        return isFirst ? 0 : Math.Max(0, elapsed);
    }

    // Towards what brings the soles that stand to the ground.
    private void Learn(float? left, float? right, double elapsed)
    {
        if ((left ?? right) is not { } rise)
            return;
        if (left is { } one && right is { } other)
            rise = (one + other) / 2;

        rise = Math.Clamp(rise, -LargestShift, LargestShift);
        _height += (rise - _height) * (float)(1 - Math.Exp(-elapsed / HipsSeconds));
    }

    private FootHold? CreateHold(HumanoidBone thigh, HumanoidBone shin, HumanoidBone foot) =>
        FootLeg.TryCreate(Rig, thigh, shin, foot) is { } leg ? new FootHold(leg) : null;
}
