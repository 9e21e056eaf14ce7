namespace NeuronMocap.Gltf;

/// <summary>
/// The keys of the animations in a GLB file. By default, there is a key for each frame. Changes apply to avatars that are added later.
/// </summary>
public sealed class GlbOptions
{
    /// <summary>Largest value of <see cref="RotationTolerance"/>, in degrees.</summary>
    public const float MaxRotationTolerance = 45;

    private const double SlowestRate = 0.01;
    private const double FastestRate = 100_000;

    private double? _frameRate;
    private float _rotationTolerance;
    private float _positionTolerance;

    /// <summary>Gets or sets the rate of even keys, 0.01 to 100,000 keys per second. Null for keys at the times of the frames.</summary>
    /// <remarks>Keys between two frames are interpolated. The first key is at the time of the first frame.</remarks>
    /// <exception cref="ArgumentOutOfRangeException">The value is outside the range.</exception>
    public double? FrameRate
    {
        get => _frameRate;
        set => _frameRate = value is null or (>= SlowestRate and <= FastestRate)
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The rate must be from 0.01 to 100,000 keys per second.");
    }

    /// <summary>
    /// Gets or sets the angle by which a bone's rotation may differ from its frame, in degrees, 0 to <see cref="MaxRotationTolerance"/>. Keys that
    /// interpolation restores within this angle are left out. 0 leaves out none, except those of bones that never rotate.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is outside the range.</exception>
    public float RotationTolerance
    {
        get => _rotationTolerance;
        set => _rotationTolerance = value is >= 0 and <= MaxRotationTolerance
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The angle must be from 0 to 45 degrees.");
    }

    /// <summary>Gets or sets the distance by which the hips may differ from their frame, in millimetres. It is like <see cref="RotationTolerance"/>.</summary>
    /// <remarks>Other bones have position keys only if their positions change. For them, the distance is at least a thousandth of a millimetre.</remarks>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative, or not finite.</exception>
    public float PositionTolerance
    {
        get => _positionTolerance;
        set => _positionTolerance = value is >= 0 and < float.PositiveInfinity
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The distance must be positive or 0.");
    }
}
