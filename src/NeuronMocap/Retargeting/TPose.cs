namespace NeuronMocap.Retargeting;

/// <summary>
/// The pose that retargeting starts from: upright, looking along +Z, legs straight down, arms, hands and fingers straight to the sides, palms down.
/// A rig that rests otherwise moves all the same, with every limb off by the difference. Thread-safe.
/// </summary>
public static class TPose
{
    /// <summary>
    /// Stands a rig into a T-pose. Only what <see cref="RigValidator"/> would find is changed: a slight bend of an elbow was meant so. Collar bones, spine and
    /// thumbs stay as they are, feet keep their slope, and the soles their height above the root; of a figure that lay they come to the root.
    /// </summary>
    /// <param name="rig">A rig at rest.</param>
    /// <returns>A rig of the same nodes, of which some are turned and the hips moved; the same rig when there is nothing to change.</returns>
    public static TargetRig Enforce(TargetRig rig)
    {
        var walk = new TPoseBuilder(rig);
        walk.Run();
        return walk.Corrections.Count > 0 ? walk.Rebuild() : rig;
    }
}
