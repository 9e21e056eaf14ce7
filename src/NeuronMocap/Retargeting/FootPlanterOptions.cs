namespace NeuronMocap.Retargeting;

/// <summary>How feet are held on the ground. Read anew for each frame, on the thread that retargets: change it there at any time.</summary>
public sealed class FootPlanterOptions
{
    private double _blendIn = 0.1;
    private double _blendOut = 0.2;
    private float? _groundHeight = 0;
    private float _largestHipsShift = 0.1f;

    /// <summary>
    /// How long a foot takes to settle on the ground once it has contact, in seconds; 0.1 unless set otherwise. Sideways it stands still from the
    /// first frame of the contact on.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">Negative, or not a finite number.</exception>
    public double BlendIn
    {
        get => _blendIn;
        set => _blendIn = Checked(value, nameof(value));
    }

    /// <summary>How long a foot takes to follow the actor's again once the contact has ended, in seconds; 0.2 unless set otherwise.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Negative, or not a finite number.</exception>
    public double BlendOut
    {
        get => _blendOut;
        set => _blendOut = Checked(value, nameof(value));
    }

    /// <summary>
    /// How high the ground is above the character's root, in metres; 0 unless set otherwise. Null: learnt from the motion, as the height that the soles come
    /// down to; the ground then rises as stairs do. A foot further from the ground than <see cref="MaxHipsShift"/> stands on something else, and keeps
    /// its height.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">Not a finite number.</exception>
    public float? GroundHeight
    {
        get => _groundHeight;
        set => _groundHeight = value is not { } height || FiniteValues.IsFinite(height)
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The height is a number of metres, or null.");
    }

    /// <summary>
    /// How far the hips may be moved up or down so that the legs reach, as a part of the length of a leg; 0.1 unless set otherwise. With 0 they stay where
    /// the actor has them.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">Below 0 or above 1.</exception>
    public float MaxHipsShift
    {
        get => _largestHipsShift;
        set => _largestHipsShift = value is >= 0 and <= 1
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The part is between 0 and 1.");
    }

    /// <summary>How a foot is turned while it stands.</summary>
    public FootRotation FootRotation { get; set; }

    private static double Checked(double seconds, string name) => seconds >= 0 && !double.IsInfinity(seconds)
        ? seconds
        : throw new ArgumentOutOfRangeException(name, seconds, "The time is a number of seconds, 0 or more.");
}

/// <summary>How a foot is turned while it stands.</summary>
public enum FootRotation
{
    /// <summary>As the actor's: it rolls from heel to toes.</summary>
    Keep,

    /// <summary>With the whole sole on the ground, and the way that it points kept: for actors whose feet tilt, and for game characters.</summary>
    Flatten,
}
