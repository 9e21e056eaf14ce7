namespace UnityEngine;

/// <summary>
/// Covers what is known outside the editor. The body is the position and rotation of the hips, divided by the height of the hips. Each muscle is an
/// angle about one of the bone's own axes. A pose that is read and written again stays the same. Muscle values differ from Unity's.
/// </summary>
public sealed class HumanPoseHandler : IDisposable
{
    private readonly Avatar _avatar;
    private readonly Transform _root;
    private readonly StandIn.HumanBones _bones;

    public HumanPoseHandler(Avatar avatar, Transform root)
    {
        if (avatar is null || !avatar.isValid || !avatar.isHuman)
            throw new ArgumentException("Avatar is not valid or not human.", nameof(avatar));

        _avatar = avatar;
        _root = root != null ? root : throw new ArgumentNullException(nameof(root));
        _bones = new StandIn.HumanBones(avatar, root);
    }

    /// <summary>Whether poses are relative to the world instead of the root. Unity's reference does not say, so tests cover both.</summary>
    internal static bool BodyIsInWorld { get; set; }

    public void GetHumanPose(ref HumanPose humanPose)
    {
        if (humanPose.muscles?.Length != HumanTrait.MuscleCount)
            humanPose.muscles = new float[HumanTrait.MuscleCount];

        Transform hips = _bones.Get(HumanBodyBones.Hips)!;
        humanPose.bodyPosition = (BodyIsInWorld ? hips.position : _root.InverseTransformPoint(hips.position)) / _bones.HipsHeight;
        humanPose.bodyRotation = BodyIsInWorld ? hips.rotation : Quaternion.Inverse(_root.rotation) * hips.rotation;
        StandIn.Muscles.Read(_bones, humanPose.muscles);
        StandIn.LimbGoals.Read(_avatar, _bones, _root, ref humanPose);
    }

    public void SetHumanPose(ref HumanPose humanPose)
    {
        if (humanPose.muscles?.Length != HumanTrait.MuscleCount)
            throw new ArgumentException("Bad array size for HumanPose.muscles.", nameof(humanPose));

        Transform hips = _bones.Get(HumanBodyBones.Hips)!;
        Vector3 position = humanPose.bodyPosition * _bones.HipsHeight;
        hips.position = BodyIsInWorld ? position : _root.TransformPoint(position);
        hips.rotation = BodyIsInWorld ? humanPose.bodyRotation : _root.rotation * humanPose.bodyRotation;
        StandIn.Muscles.Write(_bones, humanPose.muscles);
    }

    public void Dispose()
    {
    }
}
