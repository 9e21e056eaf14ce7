using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Motion;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server;

/// <summary>
/// A take from a BVH file of Neuron's 59 bones, one row for each frame. Values are broadcast as they stand in the file, bit for bit, where the
/// broadcast has the file's rotation order; positions that the file has no channels for are its OFFSETs. A broadcast without the Reference node
/// that a file has gets the hips relative to the world.
/// </summary>
public sealed class BvhSource : MotionSource
{
    private const int ReferenceValues = 6;

    private readonly BvhSkeletonMap _map;
    private readonly Lazy<FootContacts[]> _contacts;

    /// <summary>Makes a source of a file.</summary>
    /// <param name="document">The file.</param>
    /// <exception cref="NeuronException">The file's skeleton is not Neuron's, or it has no frames; the message says what is different.</exception>
    public BvhSource(BvhDocument document)
    {
        ArgumentNullException.ThrowIfNull(document);
        if (!BvhSkeletonMap.TryCreate(document, out BvhSkeletonMap? map, out string? reason))
            throw new NeuronException($"This is not a take of the 59 bones that Axis Neuron records. {reason}");
        if (document.FrameCount == 0)
            throw new NeuronException("The file holds a skeleton and no frames.");

        _map = map;
        _contacts = new Lazy<FootContacts[]>(EstimateContacts);
    }

    /// <inheritdoc/>
    public override double FrameRate => _map.Document.FrameRate;

    /// <inheritdoc/>
    public override long? FrameCount => _map.Document.FrameCount;

    /// <inheritdoc/>
    public override bool HasDisplacement => _map.Layout.HasDisplacement;

    /// <inheritdoc/>
    public override SkeletonVariant Variant => _map.Format.Variant;

    /// <summary>Order of the file's rotation values.</summary>
    public RotationOrder RotationOrder => _map.Format.RotationOrder;

    /// <inheritdoc/>
    public override void GetPose(long frame, Span<BoneTransform> pose)
    {
        int row = checked((int)frame);
        _map.CopyLocalTransforms(row, pose);
        if (_map.Layout.HasReference)
            pose[0] = _map.GetReference(row).Apply(pose[0]);
    }

    /// <summary>Which feet are on the ground, estimated from their height and speed: a file does not say. The first call reads the whole take.</summary>
    /// <param name="frame">Frame number, from 0, below <see cref="FrameCount"/>.</param>
    /// <returns>True for each foot that touches.</returns>
    public override FootContacts GetFootContacts(long frame) => _contacts.Value[checked((int)frame)];

    /// <summary>Writes the file's OFFSETs and End Sites.</summary>
    /// <param name="offsets">Room for the places of the 59 bones relative to their parents, in <see cref="Bone"/> order; centimetres.</param>
    /// <param name="endSites">Room for 59 places where the bones end, relative to them; zero for bones that have none in the file.</param>
    public override void GetBody(Span<Vector3> offsets, Span<Vector3> endSites)
    {
        SkeletonBody body = _map.GetBody();
        body.Offsets.CopyTo(offsets);
        body.EndSites.CopyTo(endSites);
    }

    /// <inheritdoc/>
    public override void WriteValues(long frame, ChannelLayout layout, RotationOrder order, Span<float> values)
    {
        if (order != RotationOrder || (_map.Layout.HasReference && !layout.HasReference))
        {
            base.WriteValues(frame, layout, order, values);
            return;
        }

        Span<float> row = stackalloc float[_map.Layout.ValueCount];
        _map.CopyValues(checked((int)frame), row);
        values[..layout.ValueCount].Clear();
        if (_map.Layout.HasReference)
            row[..ReferenceValues].CopyTo(values);

        foreach (Bone bone in BoneHierarchy.Bones)
        {
            int position = layout.GetPositionIndex(bone);
            if (position >= 0)
                WritePosition(bone, row, values[position..]);

            row.Slice(_map.Layout.GetRotationIndex(bone), 3).CopyTo(values[layout.GetRotationIndex(bone)..]);
        }
    }

    private void WritePosition(Bone bone, ReadOnlySpan<float> row, Span<float> destination)
    {
        int position = _map.Layout.GetPositionIndex(bone);
        if (position >= 0)
            row.Slice(position, 3).CopyTo(destination);
        else
            Write(destination, _map[bone].Offset);
    }

    private FootContacts[] EstimateContacts()
    {
        var feet = new FootContactTrack();
        SkeletonBody body = _map.GetBody();
        Span<BoneTransform> pose = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        for (int frame = 0; frame < _map.Document.FrameCount; frame++)
        {
            GetPose(frame, pose);
            ForwardKinematics.ToWorld(pose, pose, Variant);
            feet.Add(pose, body, frame / FrameRate);
        }

        return feet.EstimateContacts();
    }
}
