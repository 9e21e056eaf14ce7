using System.Numerics;
using NeuronMocap.Bvh;
using NeuronMocap.Motion;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server;

/// <summary>A source that plays a take from a BVH file with Neuron's 59 bones, one row for each frame.</summary>
/// <remarks>
/// If the broadcast has the rotation order of the file, the values of the file are sent bit for bit. Positions without channels in the file are its
/// OFFSETs. If the file has a reference and the broadcast has none, the hips are relative to the world.
/// </remarks>
public sealed class BvhSource : MotionSource
{
    private const int ReferenceValues = 6;

    private readonly BvhSkeletonMap _map;
    private readonly Lazy<FootContacts[]> _contacts;

    /// <summary>Creates a source from a file.</summary>
    /// <param name="document">The file.</param>
    /// <exception cref="NeuronException">
    /// The file has no frames, or its skeleton is not that of Neuron; the message then says what is different.
    /// </exception>
    public BvhSource(BvhDocument document)
    {
        ArgumentNullException.ThrowIfNull(document);
        if (!BvhSkeletonMap.TryCreate(document, out BvhSkeletonMap? map, out string? reason))
            throw new NeuronException($"This is not a take of the 59 bones that Axis Neuron records. {reason}");
        if (document.FrameCount == 0)
            throw new NeuronException("The file holds a skeleton but no frames.");

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

    /// <summary>Rotation order of the file.</summary>
    public RotationOrder RotationOrder => _map.Format.RotationOrder;

    /// <inheritdoc/>
    public override void GetPose(long frame, Span<BoneTransform> pose)
    {
        int row = checked((int)frame);
        _map.CopyLocalTransforms(row, pose);
        if (_map.Layout.HasReference)
            pose[0] = _map.GetReference(row).Apply(pose[0]);
    }

    /// <summary>
    /// Gets which feet touch the ground. BVH files hold no contacts, so they are estimated from the height and speed of the feet.
    /// </summary>
    /// <remarks>The first call reads the whole take.</remarks>
    /// <param name="frame">Frame number, from 0, below <see cref="FrameCount"/>.</param>
    /// <returns>True for each foot that touches the ground.</returns>
    public override FootContacts GetFootContacts(long frame) => _contacts.Value[checked((int)frame)];

    /// <summary>Writes the OFFSETs and End Sites of the file.</summary>
    /// <param name="offsets">Room for 59 bone positions relative to the parent bone, in <see cref="Bone"/> order; centimetres.</param>
    /// <param name="endSites">Room for 59 end points of bones, relative to the bone. Zero for bones without an End Site in the file.</param>
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
