using System.Numerics;

namespace NeuronMocap.Calculation;

/// <summary>
/// Determines which point of a bone an export contains: most exports contain the centres, some the ends.
/// </summary>
/// <remarks>
/// If an export contains ends, all thighs begin at the hips, without a hip width. The distances from the hips to the end of the thigh, and from
/// there to the end of the shank, are then constant. Between centres, both distances change as soon as a leg moves, by a centimetre even in takes
/// of half a second. The first distance is then much shorter than the second.
/// </remarks>
internal static class BonePoints
{
    private const float LargestChange = 0.5f; // cm
    private const float MinShare = 0.85f; // of the second distance; 0.6 to 0.7 between centres of real takes

    private static readonly (Bone Upper, Bone Lower)[] Legs = [(Bone.RightUpLeg, Bone.RightLeg), (Bone.LeftUpLeg, Bone.LeftLeg)];

    /// <summary>Whether a take contains the ends of the bones, according to some of its frames.</summary>
    public static bool AreEnds(CalculationDocument take, CalculationAxes axes, int[] frames)
    {
        foreach ((Bone upper, Bone lower) in Legs)
        {
            var first = new Range();
            var second = new Range();
            foreach (int i in frames)
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
