using System.Globalization;
using System.Numerics;
using System.Text;
using NeuronMocap.Retargeting;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Packaging.Tests.Documentation;

/// <summary>
/// Draws Documentation~/images/mapping.svg: the stream's skeleton from the front, a hand from above, and the Humanoid bone that follows each bone.
/// </summary>
internal sealed class MappingDiagram
{
    private const string Followed = "#d9541e";
    private const string Folded = "#8a9099";

    private readonly StringBuilder _svg = new();
    private readonly Vector3[] _joints = RestPose();
    private readonly Dictionary<Bone, HumanoidBone> _targets = Enum.GetValues<HumanoidBone>()
        .Select(static bone => (Bone: bone, Source: HumanoidMap.GetBone(bone, SkeletonVariant.Neck1, HumanoidBoneSet.All)))
        .Where(static pair => pair.Source is not null)
        .ToDictionary(static pair => pair.Source!.Value, static pair => pair.Bone);

    public static string Create() => new MappingDiagram().Draw();

    private string Draw()
    {
        _svg.Append("""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1240 800" font-family="sans-serif" font-size="13">""").Append('\n');
        _svg.Append("""<rect width="1240" height="800" fill="#ffffff"/>""").Append('\n');
        Text(20, 34, "The stream's bones, and the Humanoid bones that follow them", "#222222", 19);
        Text(20, 56, "Seen from the front: the performer's left is on the right. Grey bones have no bone of their own: the next one carries their turn.", "#444444", 13);
        Draw(static bone => !IsOfHand(bone), joint => new Vector2(340 + (joint.X * 3.6f), 770 - (joint.Y * 3.95f)));

        Text(470, 550, "Left hand from above", "#444444", 13);
        Vector3 wrist = _joints[(int)Bone.LeftHand];
        Draw(static bone => bone == Bone.LeftHand || (IsOfHand(bone) && bone > Bone.LeftHand), joint => new Vector2(450 + ((joint.X - wrist.X) * 13), 640 + ((joint.Z - wrist.Z) * 26)));
        Legend();
        return _svg.Append("</svg>\n").ToString();
    }

    private void Draw(Func<Bone, bool> isShown, Func<Vector3, Vector2> project)
    {
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            if (isShown(bone) && BoneHierarchy.GetParent(bone, SkeletonVariant.Neck1) is { } parent && isShown(parent))
                Line(project(_joints[(int)parent]), project(_joints[(int)bone]));
        }

        foreach (Bone bone in BoneHierarchy.Bones.ToArray().Where(isShown))
        {
            Vector2 at = project(_joints[(int)bone]);
            string color = _targets.ContainsKey(bone) ? Followed : Folded;
            _svg.Append(CultureInfo.InvariantCulture, $"""<circle cx="{at.X:F1}" cy="{at.Y:F1}" r="5" fill="{color}"/>""").Append('\n');

            // Seen from above, the thumb is below the index finger.
            bool isThumb = bone is >= Bone.LeftHandThumb1 and <= Bone.LeftHandThumb3;

            // The neck is to the right of it.
            bool isRightShoulder = bone == Bone.RightShoulder;
            Text(at.X + (isThumb ? -8 : isRightShoulder ? -18 : 7), at.Y + (isThumb ? 20 : -6), ((int)bone).ToString(CultureInfo.InvariantCulture), "#222222", 12);
        }
    }

    private void Legend()
    {
        float y = 90;
        foreach (Bone bone in BoneHierarchy.Bones)
        {
            if (IsOfHand(bone) && bone < Bone.LeftHand)
                continue;

            bool isFollowed = _targets.TryGetValue(bone, out HumanoidBone target);
            string name = BoneHierarchy.GetName(bone, SkeletonVariant.Neck1);
            Text(760, y, ((int)bone).ToString(CultureInfo.InvariantCulture), "#222222", 13);
            Text(790, y, name, isFollowed ? "#222222" : Folded, 13);
            Text(985, y, isFollowed ? HumanoidBones.GetName(target) : "(its turn goes to the next)", isFollowed ? Followed : Folded, 13);
            y += 16.2f;
        }

        string[] resting = [.. Enum.GetValues<HumanoidBone>().Where(static bone => HumanoidMap.GetBone(bone, SkeletonVariant.Neck1, HumanoidBoneSet.All) is null).Select(HumanoidBones.GetName)];
        Text(760, 75, "bone of the stream", "#444444", 12);
        Text(985, 75, "Humanoid bone", "#444444", 12);
        Text(20, 790, $"The right hand is as the left one: 16 to 35. No bone of the stream: {string.Join(", ", resting)}; they keep their rest pose.", "#444444", 13);
    }

    private void Line(Vector2 from, Vector2 to) => _svg.Append(CultureInfo.InvariantCulture,
        $"""<line x1="{from.X:F1}" y1="{from.Y:F1}" x2="{to.X:F1}" y2="{to.Y:F1}" stroke="#3d4a5c" stroke-width="3" stroke-linecap="round"/>""").Append('\n');

    private void Text(float x, float y, string text, string color, int size) => _svg.Append(CultureInfo.InvariantCulture,
        $"""<text x="{x:F1}" y="{y:F1}" fill="{color}" font-size="{size}">{text}</text>""").Append('\n');

    private static bool IsOfHand(Bone bone) => bone is (> Bone.RightHand and < Bone.LeftShoulder) or > Bone.LeftHand;

    private static Vector3[] RestPose()
    {
        SkeletonBody body = SkeletonBody.GetDefault();
        var local = new BoneTransform[BoneHierarchy.BoneCount];
        var world = new BoneTransform[BoneHierarchy.BoneCount];
        body.CopyRestPose(local);
        ForwardKinematics.ToWorld(local, world, body.Variant);
        return [.. world.Select(static joint => joint.Position)];
    }
}
