using System.Globalization;
using System.Numerics;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Retargeting;

/// <summary>
/// A skeleton with the names and the hierarchy of a well-known kind of rig, from a file in Rigs. The file has a line for each node: the name, the
/// position in metres in the space of the root, and the bone of the stream that it is expected to follow. Indentation is the hierarchy. $ in a name
/// stands for the side: such a node, on the right in the file, exists twice. A chain of joints, a > b > c, has three centimetres between two joints.
/// </summary>
internal sealed class RigSkeleton
{
    private static readonly string Folder = Repository.PathOf("tests", "NeuronMocap.Tests", "Retargeting", "Rigs");

    private readonly List<RigNode> _nodes = [];
    private readonly List<Vector3> _positions = [];
    private readonly (string Left, string Right) _sides;

    private RigSkeleton(string[] lines)
    {
        string[] sides = Split(lines[0]);
        _sides = (sides[1], sides[2]);
        Add(lines, 1, lines.Length, -1, "");
    }

    /// <summary>Gets the files' names, without extension.</summary>
    public static IEnumerable<string> All => Directory.EnumerateFiles(Folder, "*.txt").Select(static file => Path.GetFileNameWithoutExtension(file)!).OrderBy(static name => name, StringComparer.Ordinal);

    public RigNode[] Nodes => [.. _nodes];

    public string[] Names => [.. _nodes.Select(static node => node.Name)];

    public int[] Parents => [.. _nodes.Select(static node => node.Parent)];

    /// <summary>Gets the node that each bone of the stream should have, or -1.</summary>
    public int[] Expected { get; } = [.. Enumerable.Repeat(-1, BoneHierarchy.BoneCount)];

    public static RigSkeleton Load(string name) =>
        new([.. File.ReadAllLines(Path.Combine(Folder, name + ".txt")).Where(static line => line.Length > 0 && line[0] != '#')]);

    private static string[] Split(string line) => [.. line.Split('|').Select(static part => part.Trim())];

    private static int DepthOf(string line) => line.Length - line.TrimStart().Length;

    // Adds the nodes of some lines. A node with a side is added with all that is below it, first for the left and then for the right.
    private void Add(string[] lines, int first, int end, int parent, string side)
    {
        for (int line = first; line < end;)
        {
            int next = line + 1;
            while (next < end && DepthOf(lines[next]) > DepthOf(lines[line]))
                next++;

            string[] sides = side.Length == 0 && lines[line].Contains('$') ? ["Left", "Right"] : [side];
            foreach (string one in sides)
                Add(lines, line + 1, next, AddNodes(Split(lines[line]), parent, one), one);

            line = next;
        }
    }

    private int AddNodes(string[] parts, int parent, string side)
    {
        float[] at = [.. parts[1].Split(' ').Select(static number => float.Parse(number, CultureInfo.InvariantCulture))];
        float outwards = side == "Left" ? -1 : 1;
        var position = new Vector3(at[0] * outwards, at[1], at[2]);
        string[] chain = parts[0].Split([" > "], StringSplitOptions.None);
        for (int i = 0; i < chain.Length; i++)
        {
            string name = chain[i].Replace("$", side == "Left" ? _sides.Left : _sides.Right, StringComparison.Ordinal);
            _nodes.Add(new RigNode(name, parent, parent < 0 ? position : position - _positions[parent], Quaternion.Identity));
            _positions.Add(position);
            parent = _nodes.Count - 1;
            position.X += outwards * 0.03f;
            if (parts.Length > 2)
                Expected[(int)Enum.Parse<Bone>(side + parts[2] + (chain.Length > 1 ? $"{i + 1}" : ""))] = parent;
        }

        return parent;
    }
}
