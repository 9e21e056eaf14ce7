using System.Numerics;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Retargeting;

/// <summary>
/// Transfers poses of the stream to a character with any rest pose and any proportions.
/// </summary>
/// <remarks>
/// Each bone turns away from its own rest rotation as the actor's bone does in the world. Hip motion is scaled by leg length. The page
/// docs/guide/retargeting.md explains the method. Allocates nothing for a frame. Not thread-safe: use it on one thread at a time.
/// </remarks>
public sealed class Retargeter
{
    private readonly Quaternion[] _turns = new Quaternion[BoneHierarchy.BoneCount];
    private readonly Vector3[] _joints = new Vector3[BoneHierarchy.BoneCount];
    private RetargetLink[] _links = [];
    private float _sourceHipsHeight;
    private float _naturalScale;

    /// <summary>Creates a retargeter from an actor to a character.</summary>
    /// <param name="rig">The character.</param>
    /// <param name="body">The actor's body. Its variant must match the stream. Its sizes determine the scale of root motion.</param>
    /// <param name="options">The options. Null: the character follows the actor in everything.</param>
    public Retargeter(TargetRig rig, SkeletonBody body, RetargetOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(rig);
        ArgumentNullException.ThrowIfNull(body);
        Rig = rig;
        Body = body;
        Options = options ?? new RetargetOptions();
        SetBody(body);
    }

    /// <summary>Gets the character.</summary>
    public TargetRig Rig { get; }

    /// <summary>Gets the actor's body.</summary>
    public SkeletonBody Body { get; private set; }

    /// <summary>Gets the options, which are read for each frame.</summary>
    public RetargetOptions Options { get; }

    /// <summary>
    /// Gets how far the character moves for each metre of the actor: <see cref="RetargetOptions.Scale"/> if it is set. The default is the ratio of
    /// leg lengths. If the rig has no complete leg, it is the ratio of hip heights. If the rig has no hip height either, it is 1.
    /// </summary>
    public float Scale => Options.Scale ?? _naturalScale;

    /// <summary>Gets how many frames were rejected.</summary>
    public long RejectedCount { get; private set; }

    /// <summary>Continues with a body of other sizes or of another variant.</summary>
    /// <param name="body">The actor's body.</param>
    public void SetBody(SkeletonBody body)
    {
        ArgumentNullException.ThrowIfNull(body);
        if (_links.Length == 0 || body.Variant != Body.Variant)
            _links = RetargetLinks.Create(Rig, body.Variant);

        Body = body;
        Span<BoneTransform> rest = stackalloc BoneTransform[BoneHierarchy.BoneCount];
        body.CopyRestPose(rest);
        ForwardKinematics.ToWorld(rest, rest, body.Variant);
        _sourceHipsHeight = (rest[0].Position.Y - JointPositions.GetLowest(rest, body).Y) / 100;
        float legs = (Length(body, Bone.LeftLeg) + Length(body, Bone.LeftFoot) + Length(body, Bone.RightLeg) + Length(body, Bone.RightFoot)) / 200;
        _naturalScale = Rig.LegLength > 0 && legs > 0 ? Rig.LegLength / legs
            : Rig.HipsHeight > 0 && _sourceHipsHeight > 0 ? Rig.HipsHeight / _sourceHipsHeight
            : 1;
    }

    /// <summary>Transfers a pose to the character.</summary>
    /// <param name="localPose">
    /// 59 transforms relative to the parent, in <see cref="Bone"/> order, in centimetres. Of the positions, only that of the hips is used, unless
    /// <see cref="RetargetOptions.Displacement"/> is set.
    /// </param>
    /// <param name="result">Receives the pose. Unchanged when the frame is rejected.</param>
    /// <param name="reference">The parent of the hips: the stream's Reference node, which turns and moves the whole body. Null: none.</param>
    /// <returns>
    /// False if a value of the pose is not finite or a rotation has length zero. <see cref="RejectedCount"/> counts such frames.
    /// </returns>
    /// <exception cref="ArgumentException">There are fewer than 59 transforms, or the result belongs to another rig.</exception>
    public bool TryRetarget(ReadOnlySpan<BoneTransform> localPose, RetargetedPose result, BoneTransform? reference = null)
    {
        ArgumentNullException.ThrowIfNull(result);
        ForwardKinematics.CheckPose(localPose, nameof(localPose));
        if (result.Rig != Rig)
            throw new ArgumentException("The result belongs to another rig.", nameof(result));

        BoneTransform hips = reference is { } outer ? outer.Apply(localPose[0]) : localPose[0];
        if (!TryTurn(localPose, hips))
        {
            RejectedCount++;
            return false;
        }

        if (Options.Displacement)
            PlaceJoints(localPose);

        foreach (ref readonly RetargetLink link in _links.AsSpan())
            Apply(link, result);

        MoveHips(hips.Position, result);
        return true;
    }

    private static float Length(SkeletonBody body, Bone bone) => body.GetOffset(bone).Length();

    // The world rotation of every bone of the stream in Unity's axes. The rest rotation is the identity, so this is also the turn away from rest.
    private bool TryTurn(ReadOnlySpan<BoneTransform> localPose, in BoneTransform hips)
    {
        ReadOnlySpan<sbyte> parents = BoneHierarchy.ParentIndices(Body.Variant);
        for (int bone = 0; bone < _turns.Length; bone++)
        {
            BoneTransform local = bone == 0 ? hips : localPose[bone];
            float length = local.Rotation.Length();
            if (!(length > 1e-3f) || !FiniteValues.IsFinite(length) || !FiniteValues.IsFinite(local.Position))
                return false;

            Quaternion turn = UnityAxes.ToUnityRotation(local.Rotation) * (1 / length);
            _turns[bone] = bone == 0 ? turn : _turns[parents[bone]] * turn;
        }

        return true;
    }

    private void Apply(in RetargetLink link, RetargetedPose result)
    {
        float weight = GetWeight(link);
        if (weight == 0)
        {
            result.Rest(link.Node);
            return;
        }

        Quaternion bend = link.SourceAbove < 0 ? _turns[link.Source] : Quaternion.Conjugate(_turns[link.SourceAbove]) * _turns[link.Source];
        if (weight < 1)
            bend = Part(bend, weight);

        result.Drive(link.Node, Handedness.Apply(link.Handedness, link.Before * bend * link.After));
        if (Options.Displacement && link.SourceAbove >= 0)
            Displace(link, weight, result);
    }

    // The actor's joints relative to the hips, in Unity's axes.
    private void PlaceJoints(ReadOnlySpan<BoneTransform> localPose)
    {
        ReadOnlySpan<sbyte> parents = BoneHierarchy.ParentIndices(Body.Variant);
        for (int bone = 1; bone < _joints.Length; bone++)
            _joints[bone] = _joints[parents[bone]] + Vector3.Transform(UnityAxes.ToUnityPosition(localPose[bone].Position), _turns[parents[bone]]);
    }

    // Moves a node to the place of the actor's joint, relative to the driven bone above it. Nodes between the two are at rest.
    private void Displace(in RetargetLink link, float weight, RetargetedPose result)
    {
        Vector3 way = Vector3.Transform(_joints[link.Source] - _joints[link.SourceAbove], Quaternion.Conjugate(_turns[link.SourceAbove]));
        Vector3 shift = Vector3.Transform((way * _naturalScale) - link.RestWay, link.Before) * link.Units;
        result.Move(link.Node, Rig.LocalRestPositions[link.Node] + (shift * weight));
    }

    private void MoveHips(Vector3 position, RetargetedPose result)
    {
        Vector3 way = (UnityAxes.ToUnityPosition(position) - new Vector3(0, _sourceHipsHeight, 0)) * Scale;
        way *= Options.RootMotion switch
        {
            RootMotion.Horizontal => new Vector3(1, 0, 1),
            RootMotion.InPlace => Vector3.UnitY,
            _ => Vector3.One,
        };
        way.Y += Options.HeightOffset;
        Vector3 rest = Rig.RestPositions[Rig.HipsNode];
        result.HipsLocalPosition = Rig.ToHipsParent(rest + (Vector3.Transform(way, Rig.Facing) * GetWeight(_links[0])));
    }

    private float GetWeight(in RetargetLink link) => Rig.IsHumanoid
        ? Options.Weights.OfHumanoid(link.Part, link.Bone)
        : Options.Weights.OfBone(link.Part, link.Bone);

    // A fraction of a rotation, along the shorter way.
    private static Quaternion Part(Quaternion turn, float part)
    {
        if (turn.W < 0)
            turn = Quaternion.Negate(turn);

        var axis = new Vector3(turn.X, turn.Y, turn.Z);
        float sine = axis.Length();
        if (sine < 1e-6f)
            return Quaternion.Identity;

        float half = MathF.Atan2(sine, turn.W) * part;
        return new Quaternion(axis * (MathF.Sin(half) / sine), MathF.Cos(half));
    }
}
