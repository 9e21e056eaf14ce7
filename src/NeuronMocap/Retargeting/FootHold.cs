using System.Numerics;

namespace NeuronMocap.Retargeting;

// Where a foot has to be, frame by frame. Left alone it goes where the actor's motion has it, raised with the hips: its free way. A held foot stays
// where it was when the contact began, and settles on the ground; one that is let go comes back to its free way.
internal sealed class FootHold(FootLeg leg)
{
    // So far, in metres, a held foot may be pulled off its place before it is let go.
    private const float LargestSlip = 0.002f;

    // A foot that is further from the ground than this part of the leg stands on something else.
    private const float FurthestGround = 0.1f;

    // A foot that stands does not come this far in one frame, as a part of the leg: it stepped in frames that were missed, or the actor was put elsewhere.
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

    // What turns the actor's foot into the character's: as it is, and as it was when the contact began or ended.
    private Quaternion _turn = Quaternion.Identity;
    private Quaternion _turnBefore = Quaternion.Identity;

    public FootLeg Leg { get; } = leg;

    public bool IsHeld { get; private set; }

    // Of the ankle.
    public Vector3 Target { get; private set; }

    // How far the actor's motion is to be raised so that the sole, where it was lowest in this contact, is on the ground. Null: nothing is known.
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

    // With the ground that it stands on, where that is set to another height; not onto what is out of a foot's reach.
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

    // With the hips where they will be. A leg too short for the ground holds the foot above it, and one too short for the place lets it go.
    public void Solve(RetargetedPose pose, float shift, FootPlanterOptions options)
    {
        if (IsHeld)
            KeepWithinReach(pose, shift);

        Leg.Bend(pose, Target, Turn(options) * Leg.Rotation);
    }

    private static double Part(double elapsed, double seconds) => elapsed < seconds ? elapsed / seconds : 1;

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
