using System.Numerics;

namespace NeuronMocap.Motion;

// The One-Euro filter of one bone. A rotation is filtered by its angle: the speed is the filtered rotation vector per second, and the result moves
// along the shortest turn to the received rotation.
internal struct BoneSmoother
{
    private const float CentimetresPerMetre = 100;

    private BoneTransform _received;
    private BoneTransform _smooth;
    private Vector3 _turnRate;
    private Vector3 _velocity;

    public bool IsStarted { get; private set; }

    public readonly BoneTransform Smooth => _smooth;

    public void Start(in BoneTransform received)
    {
        _received = _smooth = received;
        _turnRate = _velocity = Vector3.Zero;
        IsStarted = true;
    }

    // elapsed: seconds, above 0.
    public void Update(in BoneTransform received, in SmoothingSettings settings, float elapsed)
    {
        // Directions are filtered together with speeds, so noise around a resting bone cancels itself out.
        float rateShare = ShareOf(settings.DerivativeCutoff, elapsed);
        _turnRate += ((QuaternionMath.TurnBetween(_received.Rotation, received.Rotation) / elapsed) - _turnRate) * rateShare;
        _velocity += (((received.Position - _received.Position) / (elapsed * CentimetresPerMetre)) - _velocity) * rateShare;
        _received = received;

        float turnCutoff = settings.MinCutoff + (settings.Beta * _turnRate.Length());
        float moveCutoff = settings.MinCutoff + (settings.Beta * _velocity.Length());
        _smooth = new BoneTransform(
            Vector3.Lerp(_smooth.Position, received.Position, ShareOf(moveCutoff, elapsed)),
            QuaternionMath.Slerp(_smooth.Rotation, received.Rotation, ShareOf(turnCutoff, elapsed)));
    }

    // The share of a new value in an exponential mean with a cutoff frequency in hertz.
    private static float ShareOf(float cutoff, float elapsed)
    {
        float angle = 2 * MathF.PI * cutoff * elapsed;
        return float.IsPositiveInfinity(angle) ? 1 : angle / (1 + angle);
    }
}
