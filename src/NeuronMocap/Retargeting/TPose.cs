namespace NeuronMocap.Retargeting;

/// <summary>
/// The pose that retargeting starts from: upright, facing +Z, legs straight down; arms, hands and fingers straight to the sides, palms down. A rig
/// with another rest pose still moves, but each limb is off by the difference. Thread-safe.
/// </summary>
public static class TPose
{
    /// <summary>
    /// Puts a rig into a T-pose.
    /// </summary>
    /// <remarks>
    /// Only deviations that <see cref="RigValidator"/> reports are changed; a slight bend of an elbow is taken as intended. Collar bones, spine and
    /// thumbs stay as they are. Feet keep their slope. The soles keep their height above the root; those of a figure that lay down move to the height
    /// of the root.
    /// </remarks>
    /// <param name="rig">A rig at rest.</param>
    /// <returns>A rig of the same nodes, with some of them turned and the hips moved. The same rig if there is nothing to change.</returns>
    public static TargetRig Enforce(TargetRig rig)
    {
        var walk = new TPoseBuilder(rig);
        walk.Run();
        return walk.Corrections.Count > 0 ? walk.Rebuild() : rig;
    }
}
