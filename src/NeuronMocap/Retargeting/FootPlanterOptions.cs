namespace NeuronMocap.Retargeting;

/// <summary>Options for foot planting. They are read for each frame, on the thread that retargets. Change them on that thread at any time.</summary>
public sealed class FootPlanterOptions
{
    private TimeSpan _blendIn = TimeSpan.FromSeconds(0.1);
    private TimeSpan _blendOut = TimeSpan.FromSeconds(0.2);
    private float? _groundHeight = 0;
    private float _maxHipsShift = 0.1f;

    /// <summary>
    /// Gets or sets how long a foot takes to settle on the ground after contact begins. The default is 0.1 s. Horizontally, the foot is
    /// still from the first frame of the contact.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative.</exception>
    public TimeSpan BlendIn
    {
        get => _blendIn;
        set => _blendIn = Checked(value, nameof(value));
    }

    /// <summary>Gets or sets how long a foot takes to follow the actor again after contact ends. The default is 0.2 s.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative.</exception>
    public TimeSpan BlendOut
    {
        get => _blendOut;
        set => _blendOut = Checked(value, nameof(value));
    }

    /// <summary>
    /// Gets or sets the height of the ground above the character's root, in metres, or null to learn it from the motion. The default is 0.
    /// </summary>
    /// <remarks>
    /// A learnt ground is the height that the soles come down to; it rises as the character climbs stairs. A foot that is further from the ground than
    /// a tenth of the leg length stands on something else, and keeps its height.
    /// </remarks>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float? GroundHeight
    {
        get => _groundHeight;
        set => _groundHeight = value is not { } height || FiniteValues.IsFinite(height)
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The height must be a number of metres, or null.");
    }

    /// <summary>
    /// Gets or sets how far the hips may move up or down so that the legs reach the ground, as a fraction of leg length. The default is 0.1. With
    /// 0 the hips stay where the actor's motion puts them.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is less than 0 or greater than 1.</exception>
    public float MaxHipsShift
    {
        get => _maxHipsShift;
        set => _maxHipsShift = value is >= 0 and <= 1
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The fraction must be a number from 0 to 1.");
    }

    /// <summary>Gets or sets how a foot is turned while it is planted.</summary>
    public FootRotation FootRotation { get; set; }

    private static TimeSpan Checked(TimeSpan time, string name) => time >= TimeSpan.Zero
        ? time
        : throw new ArgumentOutOfRangeException(name, time, "The time must not be negative.");
}

/// <summary>Specifies how a foot is turned while it is planted.</summary>
public enum FootRotation
{
    /// <summary>The foot keeps the actor's rotation: it rolls from heel to toes.</summary>
    Keep,

    /// <summary>The whole sole is on the ground, and the foot keeps its heading. For actors whose feet tilt, and for game characters.</summary>
    Flatten,
}
