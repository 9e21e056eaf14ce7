using System.Globalization;
using System.Numerics;

namespace NeuronMocap.Calculation;

/// <summary>Finds implausible bone lengths. They show that the values of an export have another meaning, or that a sensor failed.</summary>
internal static class BodyPlausibility
{
    private const float Shortest = 5; // cm
    private const float LargestDifference = 10; // cm; 2 in real takes

    // Each bone here begins where the named bone ends. Its offset is therefore the length of the named bone. Real bones are not longer than these
    // limits.
    private static readonly (string Name, Bone Left, Bone Right, float Longest)[] Bones =
    [
        ("upper leg", Bone.LeftLeg, Bone.RightLeg, 70),
        ("lower leg", Bone.LeftFoot, Bone.RightFoot, 70),
        ("upper arm", Bone.LeftForeArm, Bone.RightForeArm, 60),
        ("forearm", Bone.LeftHand, Bone.RightHand, 50),
    ];

    public static IReadOnlyList<string> Find(ReadOnlySpan<Vector3> offsets)
    {
        var warnings = new List<string>();
        foreach ((string name, Bone leftBone, Bone rightBone, float longest) in Bones)
        {
            float left = offsets[(int)leftBone].Length();
            float right = offsets[(int)rightBone].Length();
            if (!(left >= Shortest && right >= Shortest && left <= longest && right <= longest && Math.Abs(left - right) <= LargestDifference))
                warnings.Add(string.Format(CultureInfo.InvariantCulture, "The {0} is {1:0.0} cm long on the left and {2:0.0} cm on the right.", name, left, right));
        }

        return warnings;
    }
}
