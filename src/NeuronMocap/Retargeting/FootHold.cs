using System.Numerics;

namespace NeuronMocap.Retargeting;

// The target of one foot, frame by frame. A free foot follows the actor's motion, raised with the hips. A held foot stays where its contact began,
// and settles on the ground. A released foot blends back to its free position.
internal sealed class FootHold(FootLeg leg)
{
    // In metres. A held foot that is pulled further than this from its place is released.
    private const float LargestSlip = 0.002f;

    // As a fraction of the leg. A foot further from the ground stands on something else.
    private const float FurthestGround = 0.1f;

    // As a fraction of the leg. A planted foot does not move this far in one frame: either frames with a step are missing, or the actor was moved.
    private const float LongestMove = 0.1f;

    private Vector3 _ankle;
    private Vector3 _place;
    private Vector3 _offset;
    private Quaternion _flat;
    private float _startHeight;
    private float _goalHeight;
    private float _soleHeight;
    private double _sinceStart;
    private double _sinceEnd;
    private bool _isLost;

    // The turn from the actor's foot to the character's: now, and when the contact began or ended.
    private Quaternion _turn = Quaternion.Identity;
    private Quaternion _turnBefore = Quaternion.Identity;

    public FootLeg Leg { get; } = leg;

    public bool IsHeld { get; private set; }

    // The target of the ankle.
    public Vector3 Target { get; private set; }

    // How far to raise the actor's motion to put the lowest sole of this contact on the ground. Null: unknown.
    public float? Rise { get; private set; }

    public float? GetRise(float ground) =>
        Math.Abs(ground - Leg.SoleHeight) <= FurthestGround * Leg.Length ? ground - Leg.SoleHeight : null;

    public void Reset()
    {
        IsHeld = false;
        _isLost = false;
        _offset = Vector3.Zero;
        _turn = Quaternion.Identity;
        _turnBefore = Quaternion.Identity;
        Rise = null;
    }

    // Follows a change of the configured ground height, but not to ground that is out of the foot's reach.
    public void Lift(float way, float ground)
    {
        if (Rise is not { } rise || GetRise(ground) is not { } goal)
            return;

        _startHeight += way;
        _goalHeight += way;
        _soleHeight += way;
        Rise = Math.Max(rise + way, goal);
    }

    public void Step(bool contact, double elapsed, float ground, float shift, FootPlanterOptions options)
    {
        if ((IsHeld || _isLost) && Vector3.Distance(Leg.Ankle, _ankle) > LongestMove * Leg.Length)
            Reset();

        _ankle = Leg.Ankle;
        _sinceStart += elapsed;
        _sinceEnd += elapsed;
        Vector3 free = Leg.Ankle + (Leg.Up * shift);
        if (IsHeld && !contact)
            Release(free);
        _isLost &= contact;

        Target = free + (_offset * (1 - Smooth(Part(_sinceEnd, options.BlendOut))));
        if (contact && !IsHeld && !_isLost)
            Hold(ground, options.FootRotation == FootRotation.Flatten);
        if (!IsHeld)
            return;

        Rise = Rise is { } before ? Math.Max(before, GetRise(ground) ?? before) : null;
        float settled = Smooth(Part(_sinceStart, options.BlendIn));
        Target = _place + (Leg.Up * (_startHeight + ((_goalHeight - _startHeight) * settled)));
    }

    // Takes the final position of the hips. A leg too short for the ground holds the foot above it. A leg too short for the place releases the foot.
    public void Solve(RetargetedPose pose, float shift, FootPlanterOptions options)
    {
        if (IsHeld)
            KeepWithinReach(pose, shift);

        Leg.Bend(pose, Target, Turn(options) * Leg.Rotation);
    }

    private static double Part(double elapsed, TimeSpan time) => elapsed < time.TotalSeconds ? elapsed / time.TotalSeconds : 1;

    private static float Smooth(double part) => (float)(part * part * (3 - (2 * part)));

    private Quaternion Turn(FootPlanterOptions options)
    {
        Quaternion goal = Quaternion.Identity;
        if (IsHeld)
        {
            Quaternion held = options.FootRotation == FootRotation.Flatten ? _flat : Leg.KeepToesAbove(_soleHeight, Target);
            goal = held * Quaternion.Conjugate(Leg.Rotation);
        }

        double part = IsHeld ? Part(_sinceStart, options.BlendIn) : Part(_sinceEnd, options.BlendOut);
        _turn = Quaternion.Normalize(Quaternion.Slerp(_turnBefore, goal, Smooth(part)));
        return _turn;
    }

    private void Hold(float ground, bool flatten)
    {
        IsHeld = true;
        _sinceStart = 0;
        _turnBefore = _turn;
        _flat = Leg.Flattened();
        _startHeight = Leg.Height(Target);
        _place = Target - (Leg.Up * _startHeight);
        float ankle = flatten ? Leg.FlatAnkleHeight : Leg.AnkleHeight;
        Rise = GetRise(ground);
        _goalHeight = Rise is null ? _startHeight : ground + ankle;
        _soleHeight = _goalHeight - ankle;
    }

    private void Release(Vector3 free)
    {
        IsHeld = false;
        _sinceEnd = 0;
        _turnBefore = _turn;
        _offset = Target - free;
        Rise = null;
    }

    private void KeepWithinReach(RetargetedPose pose, float shift)
    {
        float lowest = Leg.LowestReached(pose, _place);
        if (lowest <= Leg.Height(Target))
            return;
        if (lowest <= Math.Max(_startHeight, _goalHeight) + LargestSlip)
        {
            _goalHeight = Math.Max(_goalHeight, lowest);
            Target = _place + (Leg.Up * lowest);
            return;
        }

        _isLost = true;
        Release(Leg.Ankle + (Leg.Up * shift));
    }
}
