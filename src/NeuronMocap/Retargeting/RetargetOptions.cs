namespace NeuronMocap.Retargeting;

/// <summary>
/// How a pose is put onto a character. Read anew for each frame, on the thread that retargets: change it there at any time.
/// </summary>
public sealed class RetargetOptions
{
    private float _heightOffset;
    private float? _scale;
    private BoneWeights _weights = new();

    /// <summary>Which of the actor's ways the character goes too.</summary>
    public RootMotion RootMotion { get; set; }

    /// <summary>How much higher than computed the hips are, in metres of the character's root.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not a finite number.</exception>
    public float HeightOffset
    {
        get => _heightOffset;
        set => _heightOffset = FiniteValues.IsFinite(value)
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The offset is a number of metres.");
    }

    /// <summary>
    /// How far the character goes for one metre of the actor's; 1 goes as far. Null: by the lengths of the legs, so that neither's feet slide;
    /// see <see cref="Retargeter.Scale"/>.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">Negative, or not a finite number.</exception>
    public float? Scale
    {
        get => _scale;
        set => _scale = value is not { } scale || (FiniteValues.IsFinite(scale) && scale >= 0)
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The scale is a number, 0 or more, or null.");
    }

    /// <summary>How much of the actor's motion each bone takes over; all of it unless set otherwise.</summary>
    /// <exception cref="ArgumentNullException">There are none.</exception>
    public BoneWeights Weights
    {
        get => _weights;
        set => _weights = value ?? throw new ArgumentNullException(nameof(value));
    }
}
