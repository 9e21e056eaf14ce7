using NeuronMocap.Skeleton;

namespace NeuronMocap.Retargeting;

// The nodes of a rig by their names, for one prefix.
internal sealed class RigNodeSearch
{
    private readonly IReadOnlyList<string> _names;
    private readonly string _prefix;
    private readonly string _suffix;
    private readonly SkeletonVariant _variant;
    private readonly IReadOnlyDictionary<Bone, string>? _overrides;
    private readonly ILookup<string, int> _byName;
    private readonly ILookup<NodeName, int> _byMeaning;

    public RigNodeSearch(IReadOnlyList<string> names, string prefix, string suffix, SkeletonVariant variant, IReadOnlyDictionary<Bone, string>? overrides)
    {
        (_names, _prefix, _suffix, _variant, _overrides) = (names, prefix, suffix, variant, overrides);
        IEnumerable<int> nodes = Enumerable.Range(0, names.Count);
        _byName = nodes.ToLookup(node => names[node], StringComparer.Ordinal);
        _byMeaning = nodes.ToLookup(node => NodeName.Read(Strip(names[node], prefix, suffix)));
    }

    public static string Strip(string name, string prefix, string suffix)
    {
        if (name.StartsWith(prefix, StringComparison.OrdinalIgnoreCase))
            name = name[prefix.Length..];
        return name.EndsWith(suffix, StringComparison.OrdinalIgnoreCase) ? name[..^suffix.Length] : name;
    }

    public RigMatch Find(RigNames row)
    {
        var match = new RigMatch(_prefix, [.. row.HipsNames.SelectMany(name => _byMeaning[name])]);
        foreach ((Bone bone, NodeName[] names) in row.Others())
            match.Add(bone, FindNodes(bone, row, names));

        AddChain(match, row, row.SpineNames, RigNames.SpineBones(_variant));
        AddChain(match, row, row.NeckNames, RigNames.NeckBones(_variant));
        if (_overrides is not null)
        {
            foreach (KeyValuePair<Bone, string> given in _overrides)
                match.Override(given.Key, [.. _byName[given.Value]]);
        }

        return match;
    }

    // In another program's rig, the bones that exist share the bones of the stream: the first takes the first, and the last takes the last.
    private void AddChain(RigMatch match, RigNames row, IReadOnlyList<NodeName[]> chain, ReadOnlySpan<Bone> bones)
    {
        if (row.IsOwn)
        {
            for (int i = 0; i < bones.Length; i++)
                match.Add(bones[i], FindNodes(bones[i], row, i < chain.Count ? chain[i] : []));

            return;
        }

        int[][] found = [.. chain.Select(names => FindNodes(names)).Where(static nodes => nodes.Length > 0)];
        int pairs = Math.Min(found.Length, bones.Length);
        for (int i = 0; i < pairs; i++)
            match.Add(bones[Spread(i, pairs, bones.Length)], found[Spread(i, pairs, found.Length)]);

        match.CountUnused(found.Length - pairs);
    }

    // The place of the i-th of some items that are spread evenly over the places, the first and the last included.
    private static int Spread(int i, int items, int places) => items == 1 ? 0 : ((2 * i * (places - 1)) + items - 1) / (2 * (items - 1));

    private int[] FindNodes(Bone bone, RigNames row, NodeName[] names)
    {
        if (row.IsOwn)
        {
            int[] exact = [.. _byName[_prefix + BoneHierarchy.GetName(bone, _variant) + _suffix]];
            if (exact.Length > 0)
                return exact;
        }

        return FindNodes(names);
    }

    private int[] FindNodes(NodeName[] names)
    {
        foreach (NodeName name in names)
        {
            if (_byMeaning.Contains(name))
                return [.. _byMeaning[name]];
        }

        return [];
    }
}
