namespace NeuronMocap.Retargeting;

/// <summary>
/// Options for retargeting. They are read for each frame, on the thread that retargets. Change them on that thread at any time.
/// </summary>
public sealed class RetargetOptions
{
    private float _heightOffset;
    private float? _scale;
    private BoneWeights _weights = new();

    /// <summary>Gets or sets which part of the actor's root motion the character follows.</summary>
    public RootMotion RootMotion { get; set; }

    /// <summary>Gets or sets an offset that raises the hips, in metres of the character's root.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float HeightOffset
    {
        get => _heightOffset;
        set => _heightOffset = FiniteValues.IsFinite(value)
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The offset must be a number of metres.");
    }

    /// <summary>
    /// Gets or sets how far the character moves for each metre of the actor. With 1 it moves as far as the actor. Null scales by leg length to
    /// prevent foot sliding; see <see cref="Retargeter.Scale"/>.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float? Scale
    {
        get => _scale;
        set => _scale = value is not { } scale || (FiniteValues.IsFinite(scale) && scale >= 0)
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The scale must be a number, 0 or more, or null.");
    }

    /// <summary>
    /// Gets or sets whether every driven bone takes over the position of the actor's bone as well as its rotation. The default is false: the character
    /// keeps its own bone lengths.
    /// </summary>
    /// <remarks>
    /// Positions are relative to the hips and scaled by leg length, whatever <see cref="Scale"/> is. The character thus takes over the actor's
    /// proportions, and keeps its size. Use it with streams that have displacement; other poses only have the known or default sizes of the actor. On
    /// a sheared rig, positions are approximate.
    /// </remarks>
    public bool Displacement { get; set; }

    /// <summary>Gets or sets how much of the actor's motion each bone takes over. By default every bone follows the actor fully.</summary>
    /// <exception cref="ArgumentNullException">The value is null.</exception>
    public BoneWeights Weights
    {
        get => _weights;
        set => _weights = value ?? throw new ArgumentNullException(nameof(value));
    }
}
