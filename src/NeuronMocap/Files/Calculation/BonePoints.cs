using System.Numerics;

namespace NeuronMocap.Calculation;

/// <summary>
/// Tells which point of a bone an export has. Most have the centres; some have the ends, and their thighs all begin at the hips, without a hip's width:
/// from the hips to the end of the thigh, and from there to the end of the shank, it is always equally far. Between centres both ways change as soon as a leg
/// moves, by a centimetre even in takes of half a second, and the first is a good deal shorter than the second.
/// </summary>
internal static class BonePoints
{
    private const float LargestChange = 0.5f; // cm
    private const float MinShare = 0.85f; // of the second way; between centres of real takes 0.6 to 0.7

    private static readonly (Bone Upper, Bone Lower)[] Legs = [(Bone.RightUpLeg, Bone.RightLeg), (Bone.LeftUpLeg, Bone.LeftLeg)];

    /// <summary>Whether a take has the ends of the bones.</summary>
    public static bool AreEnds(CalculationDocument take, CalculationAxes axes, int step)
    {
        foreach ((Bone upper, Bone lower) in Legs)
        {
            var first = new Range();
            var second = new Range();
            for (int i = 0; i < take.FrameCount; i += step)
            {
                var frame = new SensorFrame(take.GetValues(i), axes);
                Vector3 knee = frame.GetCentre(upper);
                first.Add((knee - frame.GetCentre(Bone.Hips)).Length());
                second.Add((frame.GetCentre(lower) - knee).Length());
            }

            if (!(first.Change <= LargestChange && second.Change <= LargestChange && first.Lowest > MinShare * second.Highest))
                return false;
        }

        return true;
    }

    private sealed class Range
    {
        public float Lowest { get; private set; } = float.PositiveInfinity;

        public float Highest { get; private set; } = float.NegativeInfinity;

        public float Change => Highest - Lowest;

        public void Add(float value)
        {
            if (float.IsNaN(value) || float.IsInfinity(value))
                return;

            Lowest = Math.Min(Lowest, value);
            Highest = Math.Max(Highest, value);
        }
    }
}
