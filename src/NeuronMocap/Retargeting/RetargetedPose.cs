using System.Numerics;

namespace NeuronMocap.Retargeting;

/// <summary>
/// A pose of a character: a local rotation for each node of a rig and a local position for the hips, ready to be written to transforms, in
/// Unity's axes. At rest until something is retargeted into it. All memory is allocated here, once. Not thread-safe.
/// </summary>
public sealed class RetargetedPose
{
    private readonly Quaternion[] _local;
    private readonly bool[] _driven;
    private readonly Quaternion[] _worldRotations;
    private readonly Vector3[] _worldPositions;
    private readonly Matrix4x4[]? _matrices;

    /// <summary>Makes the rest pose of a rig.</summary>
    /// <param name="rig">The character.</param>
    public RetargetedPose(TargetRig rig)
    {
        ArgumentNullException.ThrowIfNull(rig);
        Rig = rig;
        int count = rig.Nodes.Length;
        _local = new Quaternion[count];
        _driven = new bool[count];
        _worldRotations = new Quaternion[count];
        _worldPositions = new Vector3[count];
        _matrices = rig.IsSheared ? new Matrix4x4[count] : null;
        Reset();
    }

    /// <summary>The character.</summary>
    public TargetRig Rig { get; }

    /// <summary>localRotation of each node; that of a node which is not driven is its rotation at rest.</summary>
    public Span<Quaternion> LocalRotations => _local;

    /// <summary>localPosition of the hips.</summary>
    public Vector3 HipsLocalPosition { get; set; }

    /// <summary>Where the nodes are in the character's root, in metres, as of the last <see cref="UpdateWorld()"/>.</summary>
    public ReadOnlySpan<Vector3> WorldPositions => _worldPositions;

    /// <summary>How the nodes are turned in the character's root, as of the last <see cref="UpdateWorld()"/>.</summary>
    public ReadOnlySpan<Quaternion> WorldRotations => _worldRotations;

    /// <summary>Whether the pose says how a node is turned: it is a bone with a source and a weight above zero. Others are to be left alone.</summary>
    /// <param name="node">Index of a node.</param>
    /// <returns>False before the first frame, too.</returns>
    public bool IsDriven(int node) => _driven[node];

    /// <summary>Goes back to the rest pose, with no node driven.</summary>
    public void Reset()
    {
        Rig.LocalRest.CopyTo(_local);
        HipsLocalPosition = Rig.Nodes[Rig.HipsNode].Position;
        Array.Clear(_driven, 0, _driven.Length);
        UpdateWorld();
    }

    /// <summary>Computes where all nodes are: <see cref="WorldPositions"/> and <see cref="WorldRotations"/>.</summary>
    public void UpdateWorld() =>
        Rig.ComputeWorld(_local, HipsLocalPosition, _worldPositions, _worldRotations, _matrices, 0, _local.Length);

    /// <summary>The same for one node and all that hang from it; what it hangs from has to be up to date.</summary>
    /// <param name="node">Index of a node.</param>
    public void UpdateWorld(int node) =>
        Rig.ComputeWorld(_local, HipsLocalPosition, _worldPositions, _worldRotations, _matrices, node, Rig.SubtreeEnd(node));

    /// <summary>Turns a node so that it has a rotation in the character's root, and updates all that hang from it.</summary>
    /// <param name="node">Index of a node whose parent's <see cref="WorldRotations"/> are up to date.</param>
    /// <param name="rotation">A unit quaternion.</param>
    public void SetWorldRotation(int node, Quaternion rotation)
    {
        int parent = Rig.Nodes[node].Parent;
        Quaternion relative = parent < 0 ? rotation : Quaternion.Conjugate(_worldRotations[parent]) * rotation;
        SetLocalRotation(node, Handedness.Apply(Rig.HandednessAt(node), relative));
        UpdateWorld(node);
    }

    /// <summary>Moves the hips to a place in the character's root, and all that hang from them; where they are has to be up to date.</summary>
    /// <param name="position">Metres.</param>
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
    }

    internal void Rest(int node)
    {
        _driven[node] = false;
        _local[node] = Rig.LocalRest[node];
    }

    // Normalised, and of both quaternions of the rotation the one nearer to what the node had.
    private void SetLocalRotation(int node, Quaternion rotation)
    {
        float factor = 1 / rotation.Length();
        _local[node] = rotation * (Quaternion.Dot(_local[node], rotation) < 0 ? -factor : factor);
    }
}
