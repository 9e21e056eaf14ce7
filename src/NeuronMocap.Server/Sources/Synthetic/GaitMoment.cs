namespace NeuronMocap.Server.Sources.Synthetic;

// A moment in the programme of an avatar. The programme repeats every lap of 40 s: four walks, each followed by a stop. A walk of m steps has
// m + 1 swings. The first swing covers one step length, the others two, and the last one closes the feet. Swing i of a walk takes the time
// from i to i + 1. Its foot lands min(m, i + 1) steps after the start. Everything here follows from these rules.
internal readonly struct GaitMoment
{
    public const double LapSeconds = 40;

    // 1.8 steps a second.
    public const double StepSeconds = 5.0 / 9;

    // 28 steps and 4 closing swings leave 40 of the lap's 72 units for the stops. The number of swings is even, so every lap starts with the same
    // foot. The steps make two rounds of the ring, so every lap starts at the same place.
    private const double StopUnits = 10;

    private const float WalkingLag = 0.04f;
    private const float StandingLead = 0.06f;

    private readonly int _start;
    private readonly int _steps;
    private readonly bool _rightFirst;

    public GaitMoment(double seconds)
    {
        double left = seconds / StepSeconds;
        int station = 0;
        int swings = 0;
        for (int index = 0; ; index++)
        {
            int steps = Walks[index];
            if (left < steps + 1)
            {
                _rightFirst = swings % 2 == 0;
                _start = station;
                _steps = steps;
                IsWalking = true;
                Index = index;
                break;
            }

            left -= steps + 1;
            station += steps;
            swings += steps + 1;
            if (left < StopUnits || index == Walks.Length - 1)
            {
                _start = station;
                Index = index;
                break;
            }

            left -= StopUnits;
        }

        Units = (float)left;
    }

    public bool IsWalking { get; }

    // Index of the walk, or of the walk before the stop.
    public int Index { get; }

    // Time since the walk or stop began, in steps.
    public float Units { get; }

    public float Seconds => Units * (float)StepSeconds;

    // The amount of walking in the body. It grows during the first swing and fades during the last.
    public float Walking => IsWalking ? Easing.Plateau(Units, 0, 1, _steps, _steps + 1) : 0;

    // Distance of the body along the path: constant speed between an acceleration and a deceleration. When a foot lands, the body is a little nearer
    // to the other foot. Otherwise the rear leg would be longer than the front leg. At a stop the weight is in front of the ankles.
    public float Station => _start + (IsWalking ? Advance() : 0) + Easing.Lerp(StandingLead, -WalkingLag, Walking);

    // A cosine of the stride: 1 when the right foot lands in front, -1 when the left foot does.
    public float Stride => IsWalking ? -Sign * Walking * MathF.Cos(MathF.PI * Units) : 0;

    // A sine of the stride: 1 when the weight is on the left foot and the right foot passes it, -1 in the opposite case.
    public float Weight => IsWalking ? Sign * Walking * MathF.Sin(MathF.PI * Units) : 0;

    // -1 when both feet are on the ground, 1 when one foot passes the other.
    public float Rise => -Walking * MathF.Cos(2 * MathF.PI * Units);

    private static ReadOnlySpan<byte> Walks => [10, 6, 8, 4];

    private float Sign => _rightFirst ? 1 : -1;

    public FootSwing GetFoot(bool right)
    {
        if (!IsWalking)
            return new FootSwing(_start, _start, 0);

        int swing = Math.Min((int)Units, _steps);
        bool swings = right == (_rightFirst == (swing % 2 == 0));
        return swings
            ? new FootSwing(_start + Math.Max(0, swing - 1), _start + Math.Min(swing + 1, _steps), Units - swing)
            : new FootSwing(_start + swing, _start + swing, 0);
    }

    private float Advance()
    {
        if (Units < 1)
            return SpeedUp(Units);

        return Units < _steps ? Units - 0.5f : _steps - SpeedUp(_steps + 1 - Units);
    }

    // The integral of a cubic ease from rest to one step a unit.
    private static float SpeedUp(float x) => x * x * x * (1 - (x / 2));
}
