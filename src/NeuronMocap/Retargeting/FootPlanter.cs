namespace NeuronMocap.Retargeting;

/// <summary>
/// Holds a character's feet in place while they touch the ground, so that they do not slide.
/// </summary>
/// <remarks>
/// <para>
/// Feet slide when the character's proportions differ from the actor's, and when inertial sensors drift. A planted foot keeps its place from the
/// first frame of a contact to the last, and the leg bends to fit. Knees that noise bends backwards are bent forward.
/// </para>
/// <para>
/// The planter works on a retargeted pose, in the space of the character's root. Do not use it with <see cref="RootMotion.InPlace"/>, where feet
/// slide by design. Results do not depend on the frame rate. Allocates nothing for a frame. Not thread-safe.
/// </para>
/// </remarks>
public sealed class FootPlanter
{
    /// <summary>The longest time between two frames, in seconds, forward or backward. A longer time is a break: the planter resets.</summary>
    public const double MaxGap = 1;

    // The time in which the hips cover most of the distance to the height at which the feet stand: longer than a blend, shorter than a few steps.
    private const double HipsSeconds = 0.3;

    private readonly FootHold? _left;
    private readonly FootHold? _right;
    private readonly SoleHeightFilter _ground = new();
    private double _time = double.NaN;
    private float _height;
    private float? _givenGround;

    /// <summary>Creates a planter for a character.</summary>
    /// <param name="rig">The character. A leg whose thigh, shin and foot do not form a chain is left unchanged.</param>
    /// <param name="options">The options, or null for the defaults.</param>
    public FootPlanter(TargetRig rig, FootPlanterOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(rig);
        Rig = rig;
        Options = options ?? new FootPlanterOptions();
        _left = CreateHold(HumanoidBone.LeftUpperLeg, HumanoidBone.LeftLowerLeg, HumanoidBone.LeftFoot);
        _right = CreateHold(HumanoidBone.RightUpperLeg, HumanoidBone.RightLowerLeg, HumanoidBone.RightFoot);
    }

    /// <summary>Gets the character.</summary>
    public TargetRig Rig { get; }

    /// <summary>Gets the options, which are read for each frame.</summary>
    public FootPlanterOptions Options { get; }

    /// <summary>Gets the feet held in the newest frame: the feet in contact, except one that the leg can no longer reach.</summary>
    public FootContacts Planted => new(_left is { IsHeld: true }, _right is { IsHeld: true });

    /// <summary>Gets how far the hips are raised in the newest frame, in metres of the character's root. Negative values lower them.</summary>
    public float HipsShift { get; private set; }

    private float LargestShift => Options.MaxHipsShift * Rig.LegLength;

    /// <summary>Corrects hips, legs and feet of a pose.</summary>
    /// <param name="pose">
    /// The retargeted pose of the frame. Its world transforms are up to date afterwards. Legs that are not driven are left unchanged.
    /// </param>
    /// <param name="contacts">The actor's feet that touch the ground, from calculation data or estimated.</param>
    /// <param name="seconds">
    /// The time of the frame, on any clock. A time no later than the previous frame counts as the same moment. A jump back by more than
    /// <see cref="MaxGap"/>, as where a take starts again, is a break.
    /// </param>
    /// <exception cref="ArgumentException">The pose belongs to another rig.</exception>
    public void Plant(RetargetedPose pose, FootContacts contacts, double seconds)
    {
        ArgumentNullException.ThrowIfNull(pose);
        if (pose.Rig != Rig)
            throw new ArgumentException("The pose belongs to another rig.", nameof(pose));

        pose.UpdateWorld();
        bool movesHips = pose.IsDriven(Rig.HipsNode);
        double elapsed = Elapse(seconds, out bool isFirst);
        FootHold? left = Ready(_left, pose);
        FootHold? right = Ready(_right, pose);
        float ground = Options.GroundHeight ?? _ground.Update(Math.Min(SoleOf(left), SoleOf(right)), elapsed);

        // The first frame sets the height at once. Later frames approach it gradually.
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

    /// <summary>Forgets all contacts. Call it before another take, or after you move the character.</summary>
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

    // Approaches the height that puts the planted soles on the ground.
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
