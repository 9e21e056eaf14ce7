namespace NeuronMocap.Bvh;

// Moves all rows of a take along the ground and turns them about the vertical, as a whole. The hips then continue from where they were in the
// previous row.
internal sealed class BvhAlignment
{
    private const int Vertical = 1;

    private readonly int _channelCount;
    private readonly BvhJointValues[] _roots;
    private readonly BvhJointValues _hips;
    private readonly BvhJointValues? _reference;

    /// <summary>Finds the joints to move.</summary>
    /// <exception cref="NeuronException">A root lacks a position channel or a rotation channel.</exception>
    public BvhAlignment(BvhHierarchy hierarchy)
    {
        BvhJointValues[] joints = hierarchy.GetJointValues();
        _channelCount = hierarchy.ChannelCount;
        _roots = [.. joints.Where(static joint => joint.Joint.Parent is null)];
        _hips = _roots[0];
        if (BvhBoneNames.IsReference(_hips.Joint) && joints.Length > 1 && joints[1].Joint.Parent == _hips.Joint)
            (_reference, _hips) = (_hips, joints[1]);

        foreach (BvhJointValues root in _roots)
        {
            if (!root.TurnsFreely || !root.MovesFreely)
                throw new NeuronException($"Takes cannot be aligned: joint {root.Joint.Name} lacks position or rotation channels.");
        }
    }

    /// <summary>
    /// Aligns the rows from start to end with the row before them. A row with NaN has no position: the next row away from the seam replaces it.
    /// </summary>
    public void Align(float[] values, int start, int end)
    {
        int before = start - 1;
        while (before > 0 && !HasPlace(values, before))
            before--;

        int first = start;
        while (first < end - 1 && !HasPlace(values, first))
            first++;

        if (!HasPlace(values, before) || !HasPlace(values, first))
            return;

        (BvhPoint goal, BvhRotation goalRotation) = GetHips(Row(values, before));
        (BvhPoint place, BvhRotation rotation) = GetHips(Row(values, first));
        BvhRotation turn = BvhRotation.About(Vertical, (goalRotation * rotation.Inverse).Heading);

        BvhEulerTriple[] near = [.. _roots.Select(root => root.GetAngles(Row(values, before)).Or(default))];
        for (int frame = start; frame < end; frame++)
        {
            Span<float> row = Row(values, frame);
            for (int i = 0; i < _roots.Length; i++)
            {
                BvhPoint turned = turn.Turn(_roots[i].GetPosition(row) - place);
                _roots[i].SetRotation(row, turn * _roots[i].GetRotation(row), near[i]);
                _roots[i].SetPosition(row, new BvhPoint(turned.X + goal.X, turned.Y + place.Y, turned.Z + goal.Z));
                near[i] = _roots[i].GetAngles(row).Or(near[i]);
            }
        }
    }

    private bool HasPlace(float[] values, int frame)
    {
        (BvhPoint position, BvhRotation rotation) = GetHips(Row(values, frame));
        return double.IsFinite(position.Length) && double.IsFinite(rotation.Heading);
    }

    private (BvhPoint Position, BvhRotation Rotation) GetHips(ReadOnlySpan<float> row)
    {
        BvhPoint position = _hips.GetPosition(row);
        BvhRotation rotation = _hips.GetRotation(row);
        if (_reference is null)
            return (position, rotation);

        BvhRotation reference = _reference.GetRotation(row);
        return (_reference.GetPosition(row) + reference.Turn(position), reference * rotation);
    }

    private Span<float> Row(float[] values, int frame) => values.AsSpan(frame * _channelCount, _channelCount);
}
