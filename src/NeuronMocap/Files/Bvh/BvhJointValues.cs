namespace NeuronMocap.Bvh;

// Reads and writes the values of one joint within a row. If a position channel is missing, the OFFSET supplies the coordinate.
internal sealed class BvhJointValues
{
    private readonly BvhPoint _offset;
    private readonly int[] _positions = [-1, -1, -1];
    private readonly (int Column, int Axis)[] _rotations;

    public BvhJointValues(BvhJoint joint)
    {
        Joint = joint;
        _offset = joint.Offset;
        var rotations = new List<(int Column, int Axis)>();
        for (int i = 0; i < joint.Channels.Count; i++)
        {
            BvhChannel channel = joint.Channels[i];
            if (channel.IsPosition())
                _positions[channel.Axis()] = joint.FirstChannel + i;
            else if (channel.IsRotation())
                rotations.Add((joint.FirstChannel + i, channel.Axis()));
        }

        _rotations = [.. rotations];
    }

    public BvhJoint Joint { get; }

    /// <summary>Whether any rotation can be written: one channel for each axis, in any order.</summary>
    public bool TurnsFreely => _rotations.Length == 3 && _rotations.Select(static rotation => rotation.Axis).Distinct().Count() == 3;

    public bool HasPosition => _positions.Any(static column => column >= 0);

    public bool MovesFreely => _positions.All(static column => column >= 0);

    /// <summary>The axes of the rotation channels, if there are three.</summary>
    public (int First, int Second, int Third) Axes => (_rotations[0].Axis, _rotations[1].Axis, _rotations[2].Axis);

    public BvhRotation GetRotation(ReadOnlySpan<float> row)
    {
        BvhRotation rotation = BvhRotation.Identity;
        foreach ((int column, int axis) in _rotations)
            rotation *= BvhRotation.About(axis, row[column]);

        return rotation;
    }

    /// <summary>Gets the three angles. Requires <see cref="TurnsFreely"/>.</summary>
    public BvhEulerTriple GetAngles(ReadOnlySpan<float> row) =>
        new(row[_rotations[0].Column], row[_rotations[1].Column], row[_rotations[2].Column]);

    public BvhPoint GetPosition(ReadOnlySpan<float> row) => new(
        _positions[0] < 0 ? _offset.X : row[_positions[0]],
        _positions[1] < 0 ? _offset.Y : row[_positions[1]],
        _positions[2] < 0 ? _offset.Z : row[_positions[2]]);

    /// <summary>Writes a rotation as the angles that are nearest to another triple. Requires <see cref="TurnsFreely"/>.</summary>
    public void SetRotation(Span<float> row, BvhRotation rotation, BvhEulerTriple near) =>
        SetAngles(row, BvhEulerTriple.Of(rotation, Axes, near));

    /// <summary>Writes the three angles. Requires <see cref="TurnsFreely"/>.</summary>
    public void SetAngles(Span<float> row, BvhEulerTriple angles)
    {
        row[_rotations[0].Column] = (float)angles.First;
        row[_rotations[1].Column] = (float)angles.Second;
        row[_rotations[2].Column] = (float)angles.Third;
    }

    /// <summary>Writes a position into the position channels that the joint has.</summary>
    public void SetPosition(Span<float> row, BvhPoint position)
    {
        if (_positions[0] >= 0)
            row[_positions[0]] = (float)position.X;
        if (_positions[1] >= 0)
            row[_positions[1]] = (float)position.Y;
        if (_positions[2] >= 0)
            row[_positions[2]] = (float)position.Z;
    }
}
