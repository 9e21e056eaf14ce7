namespace NeuronMocap.Retargeting;

/// <summary>
/// Says what is wrong with a rig, in words for whoever made it: what is missing or mapped to the wrong node, and how far its rest pose is from a
/// <see cref="TPose"/>. A rig without issues is retargeted as the actor moves. Thread-safe.
/// </summary>
public static class RigValidator
{
    /// <summary>Examines a Humanoid rig that may have any fault.</summary>
    /// <param name="nodes">Its transforms at rest, as for <see cref="TargetRig.CreateHumanoid"/>.</param>
    /// <param name="nodeByBone">For each of the 55 bones the index of its node, or -1.</param>
    /// <returns>What was found, the worst first. What the rest pose looks like is only said once the bones are right.</returns>
    /// <exception cref="ArgumentException">There are fewer than 55 indices, or one that is not that of a node; a parent stands behind its child.</exception>
    public static IReadOnlyList<RigIssue> Validate(ReadOnlySpan<RigNode> nodes, ReadOnlySpan<int> nodeByBone)
    {
        var mapping = new RigMappingCheck(nodes, nodeByBone);
        List<RigIssue> issues = mapping.Examine();
        if (mapping.IsUsable)
            issues.AddRange(RigPoseCheck.Examine(TargetRig.CreateHumanoid(nodes, nodeByBone)));

        return WorstFirst(issues);
    }

    /// <summary>Examines the rest pose of a rig, Humanoid or generic.</summary>
    /// <param name="rig">The rig.</param>
    /// <returns>What was found, the worst first.</returns>
    public static IReadOnlyList<RigIssue> Validate(TargetRig rig)
    {
        ArgumentNullException.ThrowIfNull(rig);
        return WorstFirst(RigPoseCheck.Examine(rig));
    }

    private static RigIssue[] WorstFirst(IEnumerable<RigIssue> issues) => [.. issues.OrderByDescending(static issue => issue.Severity)];
}
