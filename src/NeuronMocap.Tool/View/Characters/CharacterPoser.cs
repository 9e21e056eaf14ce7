using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.View.Characters;

/// <summary>Transfers the poses of a performer to a character. Allocates nothing for a frame. Not thread-safe.</summary>
internal sealed class CharacterPoser
{
    private readonly Retargeter _retargeter;
    private readonly FootPlanter _planter;

    /// <summary>Creates a poser.</summary>
    /// <param name="rig">The character.</param>
    /// <param name="body">The performer's body.</param>
    public CharacterPoser(CharacterRig rig, SkeletonBody body)
    {
        Rig = rig;
        _retargeter = new Retargeter(rig.Target, body);
        _planter = new FootPlanter(rig.Target);
        Pose = new RetargetedPose(rig.Target);
    }

    public CharacterRig Rig { get; }

    /// <summary>Gets the pose of the newest frame, in Unity's axes.</summary>
    public RetargetedPose Pose { get; }

    /// <summary>Gets or sets whether feet in contact with the ground stay in their place.</summary>
    public bool PlantsFeet { get; set; } = true;

    /// <summary>Continues with a performer of other sizes.</summary>
    public void SetBody(SkeletonBody body)
    {
        if (body != _retargeter.Body)
            _retargeter.SetBody(body);
    }

    /// <summary>Forgets the frames before, as at the begin of a take or for another performer.</summary>
    public void Reset() => _planter.Reset();

    /// <summary>Takes over a pose.</summary>
    /// <param name="local">59 transforms relative to the parent, the hips in the world, in centimetres.</param>
    /// <param name="contacts">The feet that touch the ground.</param>
    /// <param name="seconds">The time of the frame on any clock.</param>
    /// <returns>False if a value of the pose is not a number; <see cref="Pose"/> is then unchanged.</returns>
    public bool TryTake(ReadOnlySpan<BoneTransform> local, FootContacts contacts, double seconds)
    {
        if (!_retargeter.TryRetarget(local, Pose))
            return false;

        if (PlantsFeet)
            _planter.Plant(Pose, contacts, seconds);
        return true;
    }
}
