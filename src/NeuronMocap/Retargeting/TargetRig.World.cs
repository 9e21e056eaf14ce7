using System.Numerics;

namespace NeuronMocap.Retargeting;

// Conversion from local values to the space of the character's root. A node's matrix is its rotation times its scale if every scale above other nodes
// is uniform except for signs. The product of all scales above is then a constant. Other scales shear. Positions of a sheared rig go through
// matrices; rotations are, as in Unity, the product of the rotations.
public sealed partial class TargetRig
{
    private readonly Quaternion[] _localRest;
    private readonly Vector3[] _localRestPositions;
    private readonly Vector3[] _handedness;
    private readonly Vector3[] _scales;
    private readonly int[] _subtreeEnds;
    private readonly bool[] _isBelowHips;
    private readonly Matrix4x4 _hipsParentBack;

    /// <summary>Gets whether the character is sheared: non-uniform scales turn with the bones below them.</summary>
    public bool IsSheared { get; }

    internal ReadOnlySpan<Quaternion> LocalRest => _localRest;

    internal ReadOnlySpan<Vector3> LocalRestPositions => _localRestPositions;

    internal Matrix4x4[]? RestMatrices { get; }

    // The index after the last descendant of a node.
    internal int SubtreeEnd(int node) => _subtreeEnds[node];

    // Also true for the hips.
    internal bool IsBelowHips(int node) => _isBelowHips[node];

    internal Vector3 HandednessAt(int node) => _handedness[node];

    // The product of the scales above a node.
    internal Vector3 ScaleAbove(int node) => _nodes[node].Parent is None ? Vector3.One : _scales[_nodes[node].Parent];

    internal Vector3 ToHipsParent(Vector3 position) => Vector3.Transform(position, _hipsParentBack);

    internal void ComputeWorld(
        ReadOnlySpan<Quaternion> local,
        ReadOnlySpan<Vector3> localPositions,
        Span<Vector3> positions,
        Span<Quaternion> rotations,
        Matrix4x4[]? matrices,
        int first,
        int end)
    {
        for (int node = first; node < end; node++)
        {
            int parent = _nodes[node].Parent;
            Quaternion rotation = Handedness.Apply(_handedness[node], local[node]);
            rotations[node] = parent == None ? rotation : rotations[parent] * rotation;
            if (matrices is not null)
            {
                Matrix4x4 matrix = Matrix(local[node], _nodes[node].Scale);
                matrix.Translation = localPositions[node];
                matrices[node] = parent == None ? matrix : matrix * matrices[parent];
                positions[node] = matrices[node].Translation;
            }
            else
            {
                positions[node] = parent == None
                    ? localPositions[node]
                    : positions[parent] + Vector3.Transform(localPositions[node] * _scales[parent], rotations[parent]);
            }
        }
    }

    // Returns whether the rig is sheared.
    private bool MeasureScales()
    {
        bool sheared = false;
        for (int node = 0; node < _nodes.Length; node++)
        {
            int parent = _nodes[node].Parent;
            Vector3 above = ScaleAbove(node);
            _handedness[node] = Handedness.FromScale(above);
            _scales[node] = above * _nodes[node].Scale;
            sheared |= !IsUniform(above);
            _isBelowHips[node] = node == HipsNode || (parent != None && _isBelowHips[parent]);
            _subtreeEnds[node] = node + 1;
            for (int ancestor = parent; ancestor != None; ancestor = _nodes[ancestor].Parent)
                _subtreeEnds[ancestor] = node + 1;
        }

        return sheared;
    }

    // Few nodes are scaled.
    private static Matrix4x4 Matrix(Quaternion rotation, Vector3 scale) => scale == Vector3.One
        ? Matrix4x4.CreateFromQuaternion(rotation)
        : Matrix4x4.CreateScale(scale) * Matrix4x4.CreateFromQuaternion(rotation);

    private static bool IsUniform(Vector3 scale)
    {
        Vector3 size = Vector3.Abs(scale);
        float difference = Math.Max(Math.Abs(size.X - size.Y), Math.Abs(size.X - size.Z));
        return difference <= 1e-6f * size.X;
    }

    private Matrix4x4 InvertHipsParent(string nodes)
    {
        Matrix4x4 above = Matrix4x4.Identity;
        for (int node = _nodes[HipsNode].Parent; node != None; node = _nodes[node].Parent)
        {
            Matrix4x4 matrix = Matrix(_nodes[node].Rotation, _nodes[node].Scale);
            matrix.Translation = _nodes[node].Position;
            above *= matrix;
        }

        return Matrix4x4.Invert(above, out Matrix4x4 back) ? back : throw new ArgumentException("An ancestor of the hips has a scale of zero.", nodes);
    }
}
