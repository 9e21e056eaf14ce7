namespace NeuronMocap.Retargeting;

// The height that the soles of a character come down to: it follows them down at once, and up as fast as one climbs stairs.
internal sealed class SoleHeightFilter
{
    // Metres per second.
    private const float MaxRise = 0.3f;

    private float _height = float.NaN;

    public void Reset() => _height = float.NaN;

    public float Update(float lowest, double elapsed)
    {
        if (FiniteValues.IsFinite(lowest))
            _height = float.IsNaN(_height) ? lowest : Math.Min(lowest, _height + (float)(elapsed * MaxRise));

        return float.IsNaN(_height) ? 0 : _height;
    }
}
