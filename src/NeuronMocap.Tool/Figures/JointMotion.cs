using System.Numerics;
using NeuronMocap.Bvh;

namespace NeuronMocap.Tool.Figures;

/// <summary>The joints and End Sites of any BVH file whose skeleton is not the 59 bones.</summary>
/// <remarks>The names of the joints identify left, right, feet and hands. Not thread-safe.</remarks>
internal sealed class JointMotion : PointMotion
{
    private readonly BvhDocument _document;
    private readonly Matrix4x4[] _world;
    private readonly WireframeLine[] _lines;
    private readonly (int Joint, Vector3 End)[] _ends;

    /// <summary>Creates the points of a file.</summary>
    /// <param name="document">A file with at least one frame.</param>
    public JointMotion(BvhDocument document)
    {
        _document = document;
        _world = new Matrix4x4[document.Joints.Count];
        _ends = [.. document.Joints.Where(static joint => joint.EndSite is not null).Select(static joint => (joint.Index, joint.EndSite!.Value))];
        _lines =
        [
            .. document.Joints.Where(static joint => joint.Parent is not null)
                .Select(static joint => new WireframeLine(joint.Parent!.Index, joint.Index, JointNames.PartOf(joint.Name))),
            .. _ends.Select((end, i) => new WireframeLine(end.Joint, document.Joints.Count + i, JointNames.PartOf(document.Joints[end.Joint].Name))),
        ];
        Roles = new PointRoles
        {
            LeftFoot = FindFoot(BodyPart.Left),
            RightFoot = FindFoot(BodyPart.Right),
            LeftHand = Find(BodyPart.Left, JointNames.IsHand),
            RightHand = Find(BodyPart.Right, JointNames.IsHand),
            LeftThigh = Find(BodyPart.Left, JointNames.IsThigh),
            RightThigh = Find(BodyPart.Right, JointNames.IsThigh),
        };
    }

    public override double FrameRate => _document.FrameRate;

    public override long FrameCount => _document.FrameCount;

    public override int PointCount => _document.Joints.Count + _ends.Length;

    public override ReadOnlySpan<WireframeLine> Lines => _lines;

    public override PointRoles Roles { get; }

    public override bool IsInCentimetres => false;

    public override void GetPoints(long frame, Span<Vector3> points)
    {
        ReadOnlySpan<float> row = _document.GetValues(checked((int)frame));
        foreach (BvhJoint joint in _document.Joints)
        {
            Matrix4x4 local = GetLocal(joint, row);
            _world[joint.Index] = joint.Parent is { } parent ? local * _world[parent.Index] : local;
            points[joint.Index] = _world[joint.Index].Translation;
        }

        for (int i = 0; i < _ends.Length; i++)
            points[_world.Length + i] = Vector3.Transform(_ends[i].End, _world[_ends[i].Joint]);
    }

    public override FootContacts? GetContacts(long frame) => null;

    // A position channel replaces that component of the OFFSET.
    private static Matrix4x4 GetLocal(BvhJoint joint, ReadOnlySpan<float> row)
    {
        Vector3 position = joint.Offset;
        for (int i = 0; i < joint.Channels.Count; i++)
        {
            if (joint.Channels[i] is >= BvhChannel.Xposition and <= BvhChannel.Zposition and var channel)
                position[channel - BvhChannel.Xposition] = row[joint.FirstChannel + i];
        }

        return Matrix4x4.CreateFromQuaternion(BvhRotations.Get(joint, row)) * Matrix4x4.CreateTranslation(position);
    }

    private int? Find(BodyPart part, Func<string, bool> isIt) =>
        _document.Joints.FirstOrDefault(joint => JointNames.PartOf(joint.Name) == part && isIt(joint.Name))?.Index;

    // Finds the ankle or foot, and all points below it in the hierarchy.
    private int[] FindFoot(BodyPart part)
    {
        if (Find(part, JointNames.IsFoot) is not { } foot)
            return [];

        var points = new HashSet<int> { foot };
        foreach (WireframeLine line in _lines)
        {
            if (points.Contains(line.From))
                points.Add(line.To);
        }

        return [.. points];
    }
}
