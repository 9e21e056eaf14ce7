namespace NeuronMocap.Retargeting;

// The height that the soles of a character come down to. It falls with the soles at once, and rises as slowly as people climb stairs.
internal sealed class SoleHeightFilter
{
    // In metres per second.
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
