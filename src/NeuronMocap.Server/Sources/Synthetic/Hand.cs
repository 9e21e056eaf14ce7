using System.Numerics;

namespace NeuronMocap.Server.Sources.Synthetic;

// The fingers of a hand. A finger is a palm bone and three bones that curl. The thumb has no palm bone.
internal static class Hand
{
    private const int FingerCount = 5;

    // Number of bones of the thumb and of each other finger. They follow the hand in Bone order.
    private const int ThumbBones = 3;
    private const int FingerBones = 4;

    // idle is an angle in radians that grows steadily. open is 1 for a flat hand. count is the number of fingers shown from a fist, and counting is
    // the amount of that gesture.
    public static void Write(bool right, float idle, float open, float count, float counting, Span<BoneTransform> pose)
    {
        Bone bone = (right ? Bone.RightHand : Bone.LeftHand) + 1;
        for (int finger = 0; finger < FingerCount; finger++)
        {
            float relaxed = 22 + (4 * finger) + (5 * MathF.Sin(idle + (0.9f * finger)));
            float curl = Easing.Lerp(relaxed, 6 + (3 * MathF.Sin(idle + finger)), open);
            curl = Easing.Lerp(curl, 82 - (74 * Easing.Step(count - finger)), counting);
            if (finger == 0)
                WriteThumb(right, bone, curl, pose);
            else
                WriteFinger(right, bone, finger, curl, open, pose);

            bone += finger == 0 ? ThumbBones : FingerBones;
        }
    }

    private static void WriteThumb(bool right, Bone bone, float curl, Span<BoneTransform> pose)
    {
        Write(pose, bone, right, Turn.Y(34 - (0.35f * curl)) * Turn.X(-30) * Turn.Z(0.3f * curl));
        Write(pose, bone + 1, right, Turn.Z(0.45f * curl));
        Write(pose, bone + 2, right, Turn.Z(0.65f * curl));
    }

    private static void WriteFinger(bool right, Bone bone, int finger, float curl, float open, Span<BoneTransform> pose)
    {
        // The fingers spread from the middle finger, more so in a flat hand. The palm cups towards the little finger.
        float spread = (2 - finger) * (1 + (4 * open));
        Write(pose, bone, right, Turn.Z(0.02f * finger * curl));
        Write(pose, bone + 1, right, Turn.Y(spread) * Turn.Z(0.9f * curl));
        Write(pose, bone + 2, right, Turn.Z(1.1f * curl));
        Write(pose, bone + 3, right, Turn.Z(0.7f * curl));
    }

    private static void Write(Span<BoneTransform> pose, Bone bone, bool right, Quaternion rotation) =>
        pose[(int)bone] = pose[(int)bone] with { Rotation = right ? rotation : Turn.Mirror(rotation) };
}
