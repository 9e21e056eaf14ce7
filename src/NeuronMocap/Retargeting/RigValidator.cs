namespace NeuronMocap.Retargeting;

/// <summary>
/// Reports what is wrong with a rig, in messages for its author. It finds bones that are missing or mapped to the wrong node, and deviations of the rest
/// pose from a <see cref="TPose"/>. A rig without issues moves as the actor does. Thread-safe.
/// </summary>
public static class RigValidator
{
    /// <summary>Examines a Humanoid rig, which may have any fault.</summary>
    /// <param name="nodes">Its transforms at rest, as for <see cref="TargetRig.CreateHumanoid"/>.</param>
    /// <param name="nodeByBone">The index of the node for each of the 55 bones, or -1.</param>
    /// <returns>The issues, the most severe first. The rest pose is examined only if the bones are correct.</returns>
    /// <exception cref="ArgumentException">
    /// There are fewer than 55 indices, an index is not that of a node, or a parent comes after its child.
    /// </exception>
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
    /// <returns>The issues, the most severe first.</returns>
    public static IReadOnlyList<RigIssue> Validate(TargetRig rig)
    {
        ArgumentNullException.ThrowIfNull(rig);
        return WorstFirst(RigPoseCheck.Examine(rig));
    }

    private static RigIssue[] WorstFirst(IEnumerable<RigIssue> issues) => [.. issues.OrderByDescending(static issue => issue.Severity)];
}
