namespace UnityEngine.StandIn;

/// <summary>
/// Plays a Humanoid clip on an Animator, as Timeline and AnimationClipPlayable do. Their Foot IK, on by default, moves the feet to the goals of the
/// clip. Goals that a clip lacks are zero: they are at the body.
/// </summary>
internal static class ClipPlayback
{
    private static readonly HumanBodyBones[] _thighs = [HumanBodyBones.LeftUpperLeg, HumanBodyBones.RightUpperLeg];

    public static void Apply(AnimationClip clip, Animator animator, float time, bool footIk = true)
    {
        float Value(string property) => clip.Curves.TryGetValue(("", typeof(Animator), property), out AnimationCurve? curve) ? curve.Evaluate(time) : 0;
        Vector3 Position(string name) => new(Value(name + ".x"), Value(name + ".y"), Value(name + ".z"));
        Quaternion Rotation(string name) => Quaternion.Normalize(new(Value(name + ".x"), Value(name + ".y"), Value(name + ".z"), Value(name + ".w")));

        Avatar avatar = animator.avatar!;
        Transform root = animator.transform;
        var pose = new HumanPose
        {
            bodyPosition = Position("RootT"),
            bodyRotation = Rotation("RootQ"),
            muscles = [.. HumanTrait.MuscleName.Select(muscle => Value(NameInClips(muscle)))],
        };
        bool isInWorld = HumanPoseHandler.BodyIsInWorld;
        HumanPoseHandler.BodyIsInWorld = false;
        using (var handler = new HumanPoseHandler(avatar, root))
            handler.SetHumanPose(ref pose);

        HumanPoseHandler.BodyIsInWorld = isInWorld;
        for (int i = 0; footIk && i < _thighs.Length; i++)
        {
            HumanBodyBones foot = LimbGoals.Bones[i];
            Quaternion rotation = pose.bodyRotation * Rotation(foot + "Q");
            Vector3 sole = (pose.bodyPosition + (pose.bodyRotation * Position(foot + "T"))) * animator.humanScale;
            Vector3 ankle = root.TransformPoint(sole - (rotation * LimbGoals.AlongBone(i)));
            Transform[] leg = [animator.GetBoneTransform(_thighs[i])!, animator.GetBoneTransform(_thighs[i] + 2)!, animator.GetBoneTransform(foot)!];
            Reach(leg[0], leg[1], leg[2], ankle, root.right);
            leg[2].rotation = root.rotation * rotation * Quaternion.Inverse(avatar.GetPostRotation((int)foot));
        }
    }

    private static string NameInClips(string muscle)
    {
        string[] words = muscle.Split(' ', 3);
        return words.Length == 3 && words[1] is "Thumb" or "Index" or "Middle" or "Ring" or "Little" ? $"{words[0]}Hand.{words[1]}.{words[2]}" : muscle;
    }

    // Bends the knee within the plane of the leg, and turns the whole leg.
    private static void Reach(Transform thigh, Transform shin, Transform foot, Vector3 target, Vector3 right)
    {
        Vector3 up = thigh.position - shin.position;
        Vector3 down = foot.position - shin.position;
        float upper = up.magnitude;
        float lower = down.magnitude;
        float reach = Mathf.Clamp((target - thigh.position).magnitude, Mathf.Abs(upper - lower) + 1e-6f, upper + lower - 1e-6f);
        float cosine = ((upper * upper) + (lower * lower) - (reach * reach)) / (2 * upper * lower);
        float bend = (Mathf.Acos(Mathf.Clamp(cosine, -1, 1)) * Mathf.Rad2Deg) - Vector3.Angle(up, down);
        Vector3 axis = Vector3.Cross(up, down);
        shin.rotation = Quaternion.AngleAxis(bend, axis.magnitude > 1e-6f ? axis : -right) * shin.rotation;
        thigh.rotation = Quaternion.FromToRotation(foot.position - thigh.position, target - thigh.position) * thigh.rotation;
    }
}
