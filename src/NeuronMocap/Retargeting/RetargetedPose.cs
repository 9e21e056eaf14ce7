using System.Numerics;

namespace NeuronMocap.Retargeting;

/// <summary>
/// A pose of a character, ready to be written to transforms in Unity's axes. It has a local rotation and a local position for each node of
/// a rig. Without <see cref="RetargetOptions.Displacement"/>, only the position of the hips differs from the rest pose. The pose is the
/// rest pose until a frame is retargeted into it. The constructor allocates all memory. Not thread-safe.
/// </summary>
public sealed class RetargetedPose
{
    private readonly Quaternion[] _local;
    private readonly Vector3[] _localPositions;
    private readonly bool[] _driven;
    private readonly bool[] _moved;
    private readonly Quaternion[] _worldRotations;
    private readonly Vector3[] _worldPositions;
    private readonly Matrix4x4[]? _matrices;

    /// <summary>Creates the rest pose of a rig.</summary>
    /// <param name="rig">The character.</param>
    public RetargetedPose(TargetRig rig)
    {
        ArgumentNullException.ThrowIfNull(rig);
        Rig = rig;
        int count = rig.Nodes.Length;
        _local = new Quaternion[count];
        _localPositions = new Vector3[count];
        _driven = new bool[count];
        _moved = new bool[count];
        _worldRotations = new Quaternion[count];
        _worldPositions = new Vector3[count];
        _matrices = rig.IsSheared ? new Matrix4x4[count] : null;
        Reset();
    }

    /// <summary>Gets the character.</summary>
    public TargetRig Rig { get; }

    /// <summary>Gets the localRotation of each node. A node that is not driven has its rest rotation.</summary>
    public Span<Quaternion> LocalRotations => _local;

    /// <summary>Gets the localPosition of each node. A node that is not moved has its rest position.</summary>
    public Span<Vector3> LocalPositions => _localPositions;

    /// <summary>Gets or sets the localPosition of the hips.</summary>
    public Vector3 HipsLocalPosition
    {
        get => _localPositions[Rig.HipsNode];
        set => _localPositions[Rig.HipsNode] = value;
    }

    /// <summary>
    /// Gets the positions of the nodes in the space of the character's root, in metres, as of the last <see cref="UpdateWorld()"/>.
    /// </summary>
    public ReadOnlySpan<Vector3> WorldPositions => _worldPositions;

    /// <summary>Gets the rotations of the nodes in the space of the character's root, as of the last <see cref="UpdateWorld()"/>.</summary>
    public ReadOnlySpan<Quaternion> WorldRotations => _worldRotations;

    /// <summary>Determines whether the pose drives a node: a bone with a source and a weight above zero. Leave other nodes as they are.</summary>
    /// <param name="node">Index of a node.</param>
    /// <returns>True if the pose drives the node. Always false before the first frame.</returns>
    public bool IsDriven(int node) => _driven[node];

    /// <summary>Determines whether the pose moves a node as well as turns it: the driven hips, and with displacement the driven bones below them.</summary>
    /// <param name="node">Index of a node.</param>
    /// <returns>True if the pose moves the node. Always false before the first frame.</returns>
    public bool IsMoved(int node) => _moved[node];

    /// <summary>Returns to the rest pose, with no driven nodes.</summary>
    public void Reset()
    {
        Rig.LocalRest.CopyTo(_local);
        Rig.LocalRestPositions.CopyTo(_localPositions);
        Array.Clear(_driven, 0, _driven.Length);
        Array.Clear(_moved, 0, _moved.Length);
        UpdateWorld();
    }

    /// <summary>Computes <see cref="WorldPositions"/> and <see cref="WorldRotations"/> of all nodes.</summary>
    public void UpdateWorld() =>
        Rig.ComputeWorld(_local, _localPositions, _worldPositions, _worldRotations, _matrices, 0, _local.Length);

    /// <summary>Computes the world positions and rotations of a node and its descendants. Those of its ancestors must be up to date.</summary>
    /// <param name="node">Index of a node.</param>
    public void UpdateWorld(int node) =>
        Rig.ComputeWorld(_local, _localPositions, _worldPositions, _worldRotations, _matrices, node, Rig.SubtreeEnd(node));

    /// <summary>Gives a node a rotation in the space of the character's root, and updates its descendants.</summary>
    /// <param name="node">Index of a node. The <see cref="WorldRotations"/> of its parent must be up to date.</param>
    /// <param name="rotation">A unit quaternion.</param>
    public void SetWorldRotation(int node, Quaternion rotation)
    {
        int parent = Rig.Nodes[node].Parent;
        Quaternion relative = parent < 0 ? rotation : Quaternion.Conjugate(_worldRotations[parent]) * rotation;
        SetLocalRotation(node, Handedness.Apply(Rig.HandednessAt(node), relative));
        UpdateWorld(node);
    }

    /// <summary>Moves the hips and their descendants. The world position of the hips must be up to date.</summary>
    /// <param name="position">The position in the space of the character's root, in metres.</param>
    public void SetHipsWorldPosition(Vector3 position)
    {
        HipsLocalPosition = Rig.ToHipsParent(position);
        Vector3 way = position - _worldPositions[Rig.HipsNode];
        for (int node = Rig.HipsNode; node < _worldPositions.Length; node++)
        {
            if (!Rig.IsBelowHips(node))
                continue;

            _worldPositions[node] += way;
            if (_matrices is not null)
                _matrices[node].Translation = _worldPositions[node];
        }
    }

    internal void Drive(int node, Quaternion rotation)
    {
        _driven[node] = true;
        SetLocalRotation(node, rotation);
        Move(node, Rig.LocalRestPositions[node], isMoved: node == Rig.HipsNode);
    }

    internal void Move(int node, Vector3 position, bool isMoved = true) => (_localPositions[node], _moved[node]) = (position, isMoved);

    internal void Rest(int node)
    {
        _driven[node] = false;
        _local[node] = Rig.LocalRest[node];
        Move(node, Rig.LocalRestPositions[node], isMoved: false);
    }

    // Normalizes. Of the two quaternions of the rotation, it takes the one closer to the node's last value.
    private void SetLocalRotation(int node, Quaternion rotation)
    {
        float factor = 1 / rotation.Length();
        _local[node] = rotation * (Quaternion.Dot(_local[node], rotation) < 0 ? -factor : factor);
    }
}
