using NeuronMocap.Skeleton;

namespace NeuronMocap.Retargeting;

/// <summary>
/// Finds the nodes of a rig by their names. Thread-safe.
/// </summary>
/// <remarks>
/// For each bone, it tries in this order:
/// <list type="number">
/// <item><description>The name given for the bone.</description></item>
/// <item><description>The exact name: prefix, the bone's name in BVH files, suffix.</description></item>
/// <item><description>The same name regardless of case and separators. The side may be a word or a letter, in front or behind.</description></item>
/// <item><description>Names common in other rigs, such as "thigh" or "upper_leg" (table in docs/guide/retargeting.md).</description></item>
/// </list>
/// </remarks>
public static class RigBinder
{
    /// <summary>Finds the nodes of the 59 bones.</summary>
    /// <param name="nodeNames">The names of all nodes, parents first.</param>
    /// <param name="prefix">
    /// What the names begin with, such as "Robot_" or "mixamorig:". Null: the text in front of the name of the hips. If several nodes could be the
    /// hips, the prefix that finds the most bones.
    /// </param>
    /// <param name="suffix">What the names end with.</param>
    /// <param name="variant">How the stream divides spine and neck.</param>
    /// <param name="overrides">Full node names, for bones whose names follow no rule. These bones are searched for under no other name.</param>
    /// <returns>The bones that were found, and those that were not.</returns>
    public static RigBinding Bind(
        IReadOnlyList<string> nodeNames,
        string? prefix = null,
        string suffix = "",
        SkeletonVariant variant = SkeletonVariant.Neck1,
        IReadOnlyDictionary<Bone, string>? overrides = null)
    {
        ArgumentNullException.ThrowIfNull(nodeNames);
        ArgumentNullException.ThrowIfNull(suffix);
        if (prefix is not null)
            return BindWith(nodeNames, prefix, suffix, variant, overrides);

        return GuessPrefixes(nodeNames, suffix)
            .Append("")
            .Select(guess => BindWith(nodeNames, guess, suffix, variant, overrides))
            .Aggregate(static (best, next) => next.FoundCount > best.FoundCount ? next : best);
    }

    private static RigBinding BindWith(
        IReadOnlyList<string> names, string prefix, string suffix, SkeletonVariant variant, IReadOnlyDictionary<Bone, string>? overrides)
    {
        NodeName[] read = [.. names.Select(name => NodeName.Read(Strip(name, prefix, suffix)))];
        int[] nodes = new int[BoneHierarchy.BoneCount];
        List<RigAmbiguity> ambiguities = [];
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            List<int> found = overrides is not null && overrides.TryGetValue(bone, out string? whole)
                ? Where(names.Count, i => string.Equals(names[i], whole, StringComparison.Ordinal))
                : Find(bone, names, read, prefix, suffix, variant);
            nodes[(int)bone] = found.Count > 0 ? found[0] : -1;
            if (found.Count > 1)
                ambiguities.Add(new RigAmbiguity(bone, found));
        }

        return new RigBinding(nodes, prefix, ambiguities);
    }

    private static List<int> Find(
        Bone bone, IReadOnlyList<string> names, NodeName[] read, string prefix, string suffix, SkeletonVariant variant)
    {
        string exact = prefix + BoneHierarchy.GetName(bone, variant) + suffix;
        List<int> found = Where(names.Count, i => string.Equals(names[i], exact, StringComparison.Ordinal));
        if (found.Count > 0)
            return found;

        foreach (NodeName accepted in BoneNames.Of(bone, variant))
        {
            found = Where(read.Length, i => read[i] == accepted);
            if (found.Count > 0)
                return found;
        }

        return found;
    }

    // The shortest prefixes first, each only once.
    private static IEnumerable<string> GuessPrefixes(IReadOnlyList<string> names, string suffix)
    {
        HashSet<string> prefixes = new(StringComparer.Ordinal);
        foreach (string name in names)
        {
            string stripped = Strip(name, "", suffix);
            foreach (string hips in BoneNames.OfHips)
            {
                if (!stripped.EndsWith(hips, StringComparison.OrdinalIgnoreCase))
                    continue;

                // "J_Bip_C_Hips" goes with "J_Bip_L_Hand".
                string prefix = stripped[..^hips.Length];
                prefixes.Add(prefix);
                if (prefix.EndsWith("C_", StringComparison.Ordinal))
                    prefixes.Add(prefix[..^2]);
            }
        }

        return prefixes.OrderBy(static prefix => prefix.Length);
    }

    private static string Strip(string name, string prefix, string suffix)
    {
        if (name.StartsWith(prefix, StringComparison.OrdinalIgnoreCase))
            name = name[prefix.Length..];
        return name.EndsWith(suffix, StringComparison.OrdinalIgnoreCase) ? name[..^suffix.Length] : name;
    }

    private static List<int> Where(int count, Func<int, bool> matches) => [.. Enumerable.Range(0, count).Where(matches)];
}
