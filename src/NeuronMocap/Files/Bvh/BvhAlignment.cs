namespace NeuronMocap.Bvh;

// Moves rows along the ground and turns them about the vertical, as a whole, so that the hips go on from where they were in the row before.
internal sealed class BvhAlignment
{
    private const int Vertical = 1;

    private readonly int _channelCount;
    private readonly BvhJointValues[] _roots;
    private readonly BvhJointValues _hips;
    private readonly BvhJointValues? _reference;

    /// <summary>Looks for what can be moved.</summary>
    /// <exception cref="NeuronException">A root lacks channels that it takes.</exception>
    public BvhAlignment(BvhHierarchy hierarchy)
    {
        BvhJointValues[] joints = hierarchy.GetJointValues();
        _channelCount = hierarchy.ChannelCount;
        _roots = [.. joints.Where(static joint => joint.Joint.Parent is null)];
        _hips = _roots[0];
        if (_hips.Joint.Name is BvhSkeletonMap.ReferenceName && joints.Length > 1 && joints[1].Joint.Parent == _hips.Joint)
            (_reference, _hips) = (_hips, joints[1]);

        foreach (BvhJointValues root in _roots)
        {
            if (!root.TurnsFreely || !root.MovesFreely)
                throw new NeuronException($"Takes cannot be aligned: {root.Joint.Name} lacks channels of its position or its rotation.");
        }
    }

    /// <summary>Aligns the rows from one to another to the row before. One of NaN is no place: then the next one away from the seam counts.</summary>
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
