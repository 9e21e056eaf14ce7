namespace NeuronMocap.Retargeting;

// Checks that the nodes are valid and mapped correctly: everything that can be checked without a rig.
internal sealed class RigMappingCheck
{
    private readonly RigNode[] _nodes;
    private readonly int[] _nodeOf;
    private readonly List<RigIssue> _issues = [];

    public RigMappingCheck(ReadOnlySpan<RigNode> nodes, ReadOnlySpan<int> nodeByBone)
    {
        if (nodeByBone.Length != HumanoidBones.Count)
            throw new ArgumentException("There must be an index for each of the 55 bones.", nameof(nodeByBone));

        _nodes = nodes.ToArray();
        _nodeOf = nodeByBone.ToArray();
        if (Array.Exists(_nodeOf, node => node < -1 || node >= _nodes.Length))
            throw new ArgumentException("An index does not belong to a node.", nameof(nodeByBone));
        for (int i = 0; i < _nodes.Length; i++)
        {
            if (_nodes[i].Parent < -1 || _nodes[i].Parent >= i)
                throw new ArgumentException($"Node {i}, {_nodes[i].Name}, comes before its parent.", nameof(nodes));
        }
    }

    // Whether the rest pose can be examined.
    public bool IsUsable { get; private set; } = true;

    public List<RigIssue> Examine()
    {
        CheckTransforms();
        CheckNames();
        for (int bone = 0; bone < HumanoidBones.Count; bone++)
            CheckBone((HumanoidBone)bone);

        return _issues;
    }

    private static bool IsSound(in RigNode node) => FiniteValues.IsFinite(node.Position) && FiniteValues.IsFinite(node.Rotation)
        && FiniteValues.IsFinite(node.Scale) && node.Rotation.LengthSquared() > 1e-6f && node.Scale.X * node.Scale.Y * node.Scale.Z != 0;

    private void CheckTransforms()
    {
        foreach (RigNode node in _nodes)
        {
            if (IsSound(node))
                continue;

            IsUsable = false;
            Add(RigFault.InvalidTransform, RigSeverity.Error, null,
                $"The transform {node.Name} has a position, rotation or scale that is not a number, or a scale of zero. Repair it in the program that made the rig.");
        }
    }

    private void CheckNames()
    {
        foreach (IGrouping<string, RigNode> same in _nodes.GroupBy(static node => node.Name, StringComparer.Ordinal).Where(static group => group.Skip(1).Any()))
        {
            Add(RigFault.DuplicateName, RigSeverity.Warning, null,
                $"{same.Count()} transforms are called {same.Key}. Unity finds bones by name and may take the wrong one: rename all but one.");
        }
    }

    private void CheckBone(HumanoidBone bone)
    {
        string name = HumanoidBones.GetName(bone);
        int node = _nodeOf[(int)bone];
        if (node < 0)
        {
            if (HumanoidBones.IsRequired(bone))
            {
                IsUsable &= bone != HumanoidBone.Hips;
                Add(RigFault.MissingBone, RigSeverity.Error, bone, $"{name} is not mapped. Unity cannot create a Humanoid without it. Map it in the avatar's configuration.");
            }

            return;
        }

        int first = Array.IndexOf(_nodeOf, node);
        if (first < (int)bone)
        {
            IsUsable = false;
            Add(RigFault.DuplicateMapping, RigSeverity.Error, bone,
                $"{_nodes[node].Name} is mapped to {HumanoidBones.GetName((HumanoidBone)first)} and to {name}. Map it to one of them.");
        }
        else if (AncestorOf(bone) is { } ancestor && !IsDescendantOf(node, _nodeOf[(int)ancestor]))
        {
            IsUsable = false;
            Add(RigFault.InvalidHierarchy, RigSeverity.Error, bone,
                $"{name} is mapped to {_nodes[node].Name}, which is not below {_nodes[_nodeOf[(int)ancestor]].Name}, the {HumanoidBones.GetName(ancestor)}. Map the bones from the hips outwards.");
        }

        if (SideOf(bone) is { } side && side != BodySide.None && NodeName.Read(_nodes[node].Name).Side is not BodySide.None and var said && said != side)
        {
            Add(RigFault.SidesSwapped, RigSeverity.Error, bone,
                $"{name} is mapped to {_nodes[node].Name}, whose name says that it is on the other side. Swap left and right in the mapping.");
        }
    }

    private static BodySide? SideOf(HumanoidBone bone) => NodeName.Read(HumanoidBones.GetName(bone)).Side;

    // The closest ancestor that is mapped.
    private HumanoidBone? AncestorOf(HumanoidBone bone)
    {
        HumanoidBone? ancestor = HumanoidBones.GetParent(bone);
        while (ancestor is { } unmapped && _nodeOf[(int)unmapped] < 0)
            ancestor = HumanoidBones.GetParent(unmapped);

        return ancestor;
    }

    private bool IsDescendantOf(int node, int ancestor)
    {
        while (node > ancestor)
            node = _nodes[node].Parent;

        return node == ancestor;
    }

    private void Add(RigFault fault, RigSeverity severity, HumanoidBone? bone, string message) =>
        _issues.Add(new RigIssue(fault, severity, bone, 0, message, CanFix: false));
}
