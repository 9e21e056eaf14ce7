using NeuronMocap.Skeleton;

namespace NeuronMocap.Motion;

/// <summary>
/// Smooths the poses of a performer, frame by frame, with a One-Euro filter for each bone. Does not allocate memory after the constructor. Not
/// thread-safe.
/// </summary>
/// <remarks>
/// Frames may have any spacing. If the time goes back, or no frame came for <see cref="MaxGap"/>, the filters start again at the given pose. Use
/// transforms relative to the parents; in the world, bones would change their lengths. At first, all filters are off.
/// </remarks>
public sealed class PoseSmoother
{
    /// <summary>The longest time between two frames that the filters bridge, in seconds.</summary>
    public const double MaxGap = 0.5;

    private readonly SmoothingSettings[] _settings = new SmoothingSettings[BoneHierarchy.BoneCount];
    private readonly BoneSmoother[] _filters = new BoneSmoother[BoneHierarchy.BoneCount];
    private double _time = double.NaN;

    /// <summary>Gets or sets the settings of a bone. A change applies from the next frame on.</summary>
    /// <param name="bone">The bone.</param>
    /// <exception cref="ArgumentOutOfRangeException">The bone is not defined, or a setting is negative or not finite.</exception>
    public SmoothingSettings this[Bone bone]
    {
        get => _settings[BoneHierarchy.CheckedIndex(bone)];
        set => _settings[BoneHierarchy.CheckedIndex(bone)] = SmoothingSettings.Checked(value);
    }

    /// <summary>Gives all bones the same settings.</summary>
    /// <param name="settings">The settings.</param>
    /// <exception cref="ArgumentOutOfRangeException">A setting is negative or not finite.</exception>
    public void SetAll(SmoothingSettings settings) => Array.Fill(_settings, SmoothingSettings.Checked(settings));

    /// <summary>Smooths a pose in place.</summary>
    /// <param name="pose">
    /// 59 transforms relative to their parents, in <see cref="Bone"/> order. A transform that is not finite stays as it is.
    /// </param>
    /// <param name="seconds">
    /// The time of the frame on any clock. A frame with the time of the previous one receives the previous result.
    /// </param>
    /// <exception cref="ArgumentException">There are fewer than 59 transforms.</exception>
    public void Smooth(Span<BoneTransform> pose, double seconds)
    {
        ForwardKinematics.CheckPose(pose, nameof(pose));
        double elapsed = seconds - _time;
        _time = seconds;

        // Comparisons with NaN are false: the first frame starts the filters, too.
        bool continues = elapsed >= 0 && elapsed <= MaxGap;
        for (int bone = 0; bone < BoneHierarchy.BoneCount; bone++)
        {
            ref BoneSmoother filter = ref _filters[bone];
            if (!IsFinite(pose[bone]))
            {
                filter = default;
                continue;
            }

            if (!continues || !filter.IsStarted || _settings[bone].IsOff)
                filter.Start(pose[bone]);
            else if (elapsed > 0)
                filter.Update(pose[bone], _settings[bone], (float)elapsed);

            pose[bone] = filter.Smooth;
        }
    }

    /// <summary>Forgets all frames. Call this before smoothing another performer.</summary>
    public void Reset() => _time = double.NaN;

    private static bool IsFinite(in BoneTransform transform) =>
        float.IsFinite(transform.Position.LengthSquared()) && float.IsFinite(transform.Rotation.LengthSquared());
}
