using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Sources;

// A source that can be turned to face front, for the zero-out of the broadcaster. It stays a pure function of the frame number: a turn applies from
// the first frame that nothing has read yet, so it never changes a frame that was sent. Only the newest turns are kept. A reader that is further
// behind gets the oldest kept turn.
internal sealed class ZeroOutSource(MotionSource source) : MotionSource
{
    // Limits the memory of a client that zeroes out at every frame.
    public const int MaxTurns = 1024;

    private readonly object _lock = new();
    private readonly List<(long From, MotionSource Source, BoneTransform Turn)> _turns = [(0, source, BoneTransform.Identity)];
    private long _newest = -1;

    public int TurnCount
    {
        get
        {
            lock (_lock)
                return _turns.Count;
        }
    }

    public override double FrameRate => source.FrameRate;

    public override long? FrameCount => source.FrameCount;

    public override bool HasDisplacement => source.HasDisplacement;

    public override SkeletonVariant Variant => source.Variant;

    // Does nothing and returns true if no frame is left to turn. Returns false if the pose is not finite: such a pose has no front, and the
    // values computed from it would spoil all later frames.
    public bool FaceFront(long frameCount)
    {
        Span<BoneTransform> pose = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        lock (_lock)
        {
            long from = _newest + 1;
            if (from >= Math.Min(frameCount, FrameCount ?? long.MaxValue))
                return true;

            (long last, MotionSource current, BoneTransform turn) = _turns[^1];
            current.GetPose(from, pose);
            BoneTransform next = TurnToFront(pose[(int)Bone.Hips]).Apply(turn);
            if (!IsFinite(pose[(int)Bone.Hips]) || !IsFinite(next))
                return false;

            if (last == from)
                _turns.RemoveAt(_turns.Count - 1);
            else if (_turns.Count == MaxTurns)
                _turns.RemoveAt(0);

            _turns.Add((from, new RotatedSource(source, next), next));
            return true;
        }
    }

    public override void GetPose(long frame, Span<BoneTransform> pose) => At(frame).GetPose(frame, pose);

    public override FootContacts GetFootContacts(long frame) => source.GetFootContacts(frame);

    public override void GetBody(Span<Vector3> offsets, Span<Vector3> endSites) => source.GetBody(offsets, endSites);

    public override void WriteValues(long frame, ChannelLayout layout, RotationOrder order, Span<float> values) =>
        At(frame).WriteValues(frame, layout, order, values);

    internal override MotionSource At(long frame)
    {
        lock (_lock)
        {
            _newest = Math.Max(_newest, frame);
            int i = _turns.Count - 1;
            while (i > 0 && _turns[i].From > frame)
                i--;

            return _turns[i].Source;
        }
    }

    private static bool IsFinite(in BoneTransform transform) =>
        float.IsFinite(transform.Position.LengthSquared()) && float.IsFinite(transform.Rotation.LengthSquared());

    // Turns about the vertical axis through the hips. The position of the hips does not change.
    private static BoneTransform TurnToFront(BoneTransform hips)
    {
        Quaternion rotation = Quaternion.CreateFromAxisAngle(Vector3.UnitY, -Heading(hips.Rotation));
        return new BoneTransform(hips.Position - Vector3.Transform(hips.Position, rotation), rotation);
    }

    // The angle of the forward direction on the ground. For a lying body, which faces up or down, the turn about the vertical axis counts.
    private static float Heading(Quaternion rotation)
    {
        const float NearlyVertical = 0.1f;
        Vector3 forward = Vector3.Transform(Vector3.UnitZ, rotation);
        return new Vector2(forward.X, forward.Z).Length() > NearlyVertical
            ? MathF.Atan2(forward.X, forward.Z)
            : 2 * MathF.Atan2(rotation.Y, rotation.W);
    }
}
