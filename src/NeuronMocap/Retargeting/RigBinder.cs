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
/// It knows the names of several programs, and uses those that find the most bones. If several nodes could be the hips, such as "hip" and
/// "pelvis", it takes the node that carries both the legs and the spine.
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
    /// <param name="parents">The index of each node's parent, or -1. Null: unknown. The hips are then found by name only.</param>
    /// <returns>The bones that were found, and those that were not.</returns>
    /// <exception cref="ArgumentException">There is not one parent for each name, or a parent comes after its child.</exception>
    public static RigBinding Bind(
        IReadOnlyList<string> nodeNames,
        string? prefix = null,
        string suffix = "",
        SkeletonVariant variant = SkeletonVariant.Neck1,
        IReadOnlyDictionary<Bone, string>? overrides = null,
        IReadOnlyList<int>? parents = null)
    {
        ArgumentNullException.ThrowIfNull(nodeNames);
        ArgumentNullException.ThrowIfNull(suffix);
        CheckParents(nodeNames.Count, parents);

        // The first of equally good searches wins: the shortest prefix, and the stream's own names.
        IEnumerable<string> prefixes = prefix is not null ? [prefix] : GuessPrefixes(nodeNames, suffix).Append("");
        return prefixes
            .Select(tried => new RigNodeSearch(nodeNames, tried, suffix, variant, overrides))
            .SelectMany(search => RigNames.Rows(variant).Select(search.Find))
            .Aggregate(static (best, next) => next.MatchCount > best.MatchCount ? next : best)
            .ToBinding(parents);
    }

    private static void CheckParents(int count, IReadOnlyList<int>? parents)
    {
        if (parents is null)
            return;
        if (parents.Count != count)
            throw new ArgumentException("There must be a parent for each name.", nameof(parents));

        for (int node = 0; node < count; node++)
        {
            if (parents[node] < -1 || parents[node] >= node)
                throw new ArgumentException($"Node {node} comes before its parent.", nameof(parents));
        }
    }

    // The shortest prefixes first, each only once.
    private static IEnumerable<string> GuessPrefixes(IReadOnlyList<string> names, string suffix)
    {
        HashSet<string> prefixes = new(StringComparer.Ordinal);
        string[] allHips = [.. RigNames.HipsWords];
        foreach (string name in names)
        {
            string stripped = RigNodeSearch.Strip(name, "", suffix);
            foreach (string hips in allHips)
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
}
