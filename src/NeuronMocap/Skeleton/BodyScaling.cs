using System.Numerics;

namespace NeuronMocap.Skeleton;

// Stretches the default body to twelve sizes. BoneDimensions.Measure returns the same sizes for the result.
internal static class BodyScaling
{
    public static SkeletonBody Create(in BoneDimensions wanted, SkeletonVariant variant)
    {
        Check(wanted);
        var standard = SkeletonBody.GetDefault(variant);
        BoneDimensions known = standard.Measure();
        Vector3[] offsets = standard.Offsets.ToArray();
        Vector3[] endSites = standard.EndSites.ToArray();

        Bone neck = variant == SkeletonVariant.Spine3 ? Bone.Neck1 : Bone.Neck;
        Scale(offsets, Bone.Spine, neck, wanted.Body / known.Body);
        Scale(offsets, neck + 1, Bone.Head, wanted.Neck / known.Neck);
        endSites[(int)Bone.Head] *= wanted.Head / known.Head;
        foreach (bool right in (ReadOnlySpan<bool>)[true, false])
        {
            ScaleArm(offsets, endSites, wanted, known, right);
            ScaleLeg(offsets, endSites, wanted, known, right);
        }

        return SkeletonBody.Standing(offsets, endSites, variant);
    }

    private static void ScaleArm(Vector3[] offsets, Vector3[] endSites, in BoneDimensions wanted, in BoneDimensions known, bool right)
    {
        Bone shoulder = right ? Bone.RightShoulder : Bone.LeftShoulder;
        float width = wanted.ShoulderWidth / known.ShoulderWidth;
        offsets[(int)shoulder] *= new Vector3(width, wanted.Body / known.Body, 1);
        offsets[(int)shoulder + 1] *= width;
        offsets[(int)shoulder + 2] *= wanted.UpperArm / known.UpperArm;
        offsets[(int)shoulder + 3] *= wanted.Forearm / known.Forearm;

        // From the thumb to the end of the little finger.
        Bone first = shoulder + 4;
        Bone last = right ? Bone.RightHandPinky3 : Bone.LeftHandPinky3;
        Scale(offsets, first, last, wanted.Palm / known.Palm);
        Scale(endSites, first, last, wanted.Palm / known.Palm);
    }

    private static void ScaleLeg(Vector3[] offsets, Vector3[] endSites, in BoneDimensions wanted, in BoneDimensions known, bool right)
    {
        int thigh = (int)(right ? Bone.RightUpLeg : Bone.LeftUpLeg);
        float length = wanted.FootLength / known.FootLength;
        offsets[thigh] *= wanted.HipWidth / known.HipWidth;
        offsets[thigh + 1] *= wanted.UpperLeg / known.UpperLeg;
        offsets[thigh + 2] *= wanted.LowerLeg / known.LowerLeg;
        endSites[thigh + 2] *= new Vector3(length, wanted.HeelHeight / known.HeelHeight, length);
    }

    private static void Scale(Vector3[] places, Bone first, Bone last, float factor)
    {
        for (Bone bone = first; bone <= last; bone++)
            places[(int)bone] *= factor;
    }

    private static void Check(in BoneDimensions sizes)
    {
        Span<byte> wire = stackalloc byte[BoneDimensions.Size];
        sizes.Write(wire);
        if (!BoneDimensions.TryRead(wire, out _))
            throw new ArgumentException("Every size must be a number of metres, 0 or more.", nameof(sizes));
    }
}
