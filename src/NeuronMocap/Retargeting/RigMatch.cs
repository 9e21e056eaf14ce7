using NeuronMocap.Skeleton;

namespace NeuronMocap.Retargeting;

// The nodes that the names of one kind of rig find.
internal sealed class RigMatch
{
    private readonly int[] _nodes = [.. Enumerable.Repeat(-1, BoneHierarchy.BoneCount)];
    private readonly SortedDictionary<Bone, IReadOnlyList<int>> _ambiguities = [];
    private readonly string _prefix;
    private readonly int[] _hips;
    private bool _isHipsGiven;

    // hips: all nodes with a name of the hips.
    public RigMatch(string prefix, int[] hips) => (_prefix, _hips) = (prefix, hips);

    // How many of the names are in the rig.
    public int MatchCount { get; private set; }

    public void Add(Bone bone, int[] found)
    {
        if (found.Length == 0)
            return;

        MatchCount++;
        _nodes[(int)bone] = found[0];
        if (found.Length > 1)
            _ambiguities[bone] = found;
    }

    public void CountUnused(int count) => MatchCount += count;

    public void Override(Bone bone, int[] found)
    {
        _isHipsGiven |= bone == Bone.Hips;
        MatchCount -= _nodes[(int)bone] >= 0 ? 1 : 0;
        _nodes[(int)bone] = -1;
        _ambiguities.Remove(bone);
        Add(bone, found);
    }

    public RigBinding ToBinding(IReadOnlyList<int>? parents)
    {
        if (parents is not null && !_isHipsGiven)
            FindHips(parents);

        return new RigBinding(_nodes, _prefix, [.. _ambiguities.Select(static pair => new RigAmbiguity(pair.Key, pair.Value))]);
    }

    // The hips carry both legs and spine, so they are the closest node above all of them that has a name of the hips. A spine bone that carries a leg,
    // as in some Bipeds, is a part of the hips.
    private void FindHips(IReadOnlyList<int> parents)
    {
        int[] legs = [.. new[] { Bone.RightUpLeg, Bone.LeftUpLeg }.Select(bone => _nodes[(int)bone]).Where(static node => node >= 0)];
        int[] spine = [.. Enumerable.Range((int)Bone.Spine, Bone.Head - Bone.Spine + 1).Select(bone => _nodes[bone]).Where(static node => node >= 0)];
        if (legs.Length == 0 || spine.Length == 0)
            return;

        int above = legs.Concat(spine).Aggregate((one, other) => FindCommonAncestor(one, other, parents));
        while (above >= 0 && Array.IndexOf(_hips, above) < 0)
            above = parents[above];
        if (above >= 0 && _nodes[0] != above)
        {
            _nodes[0] = above;
            _ambiguities.Remove(Bone.Hips);
        }

        for (Bone bone = Bone.Spine; bone < Bone.Head; bone++)
        {
            int node = _nodes[(int)bone];
            if (node >= 0 && legs.Any(leg => FindCommonAncestor(leg, node, parents) == node))
                _nodes[(int)bone] = -1;
        }
    }

    // Parents come before their children.
    private static int FindCommonAncestor(int one, int other, IReadOnlyList<int> parents)
    {
        while (one != other && one >= 0 && other >= 0)
        {
            if (one > other)
                one = parents[one];
            else
                other = parents[other];
        }

        return one == other ? one : -1;
    }
}
