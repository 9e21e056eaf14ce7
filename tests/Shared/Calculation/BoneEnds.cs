using System.Globalization;
using System.Numerics;
using System.Text;
using NeuronMocap.Calculation;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tests.Calculation;

/// <summary>
/// Exports in the format of some servers: a header with Zd and the number of bones, ends of bones instead of their centres, thighs that start at the
/// hips, and no rotation for bones without a sensor.
/// </summary>
internal static class BoneEnds
{
    private static readonly Bone[] WithoutSensor = [Bone.Spine, Bone.Spine1, Bone.Neck, Bone.Neck1];

    private static readonly Bone[][] Chains =
    [
        [Bone.RightUpLeg, Bone.RightLeg, Bone.RightFoot],
        [Bone.LeftUpLeg, Bone.LeftLeg, Bone.LeftFoot],
        [Bone.Spine, Bone.Spine1, Bone.Spine2, Bone.Neck, Bone.Neck1, Bone.Head],
        [Bone.RightShoulder, Bone.RightArm, Bone.RightForeArm, Bone.RightHand],
        [Bone.LeftShoulder, Bone.LeftArm, Bone.LeftForeArm, Bone.LeftHand],
    ];

    /// <summary>Writes a take of the synthetic actor.</summary>
    public static string Write(int frames, bool stands = false)
    {
        var actor = new SyntheticSource(120);
        var text = new StringBuilder("Zd:\t0.1736\t0.9848\t0.0000\r\nbones:\t59\r\n\r\n\r\n\r\n");
        text.Append(string.Join('\t', Enumerable.Range(1, 59).SelectMany(static bone => "XVQAW".Select(kind => $"{bone:00}-{kind}")))).Append("\r\n");
        float[] values = new float[CalculationFrame.FullValueCount];
        for (int frame = 0; frame < frames; frame++)
        {
            Fill(actor, stands ? 0 : frame, values);
            foreach (float value in values)
                text.Append(value.ToString("F4", CultureInfo.InvariantCulture)).Append('\t');

            text.Append("\r\n");
        }

        return text.ToString();
    }

    private static void Fill(SyntheticSource actor, int frame, float[] values)
    {
        BoneTransform[] pose = new BoneTransform[BoneHierarchy.BoneCount];
        Vector3[] offsets = new Vector3[BoneHierarchy.BoneCount];
        Vector3[] ends = new Vector3[BoneHierarchy.BoneCount];
        actor.GetPose(frame, pose);
        actor.GetBody(offsets, ends);
        ForwardKinematics.ToWorld(pose, pose, actor.Variant);
        CalculationSynthesizer.Write(actor, frame, values);
        foreach (Bone[] chain in Chains)
        {
            Vector3 start = pose[0].Position;
            for (int i = 0; i < chain.Length; i++)
            {
                Vector3 length = i + 1 < chain.Length ? offsets[(int)chain[i + 1]] : ends[(int)chain[i]];
                start += Vector3.Transform(length, pose[(int)chain[i]].Rotation);
                Span<float> bone = values.AsSpan(CalculationOrder.IndexOf(chain[i]) * 16);
                (bone[0], bone[1], bone[2]) = (start.X / 100, start.Y / 100, start.Z / 100);
                if (WithoutSensor.Contains(chain[i]))
                    (bone[6], bone[7], bone[8], bone[9]) = (1, 0, 0, 0);
            }
        }

        CalculationAxes.Export.ConvertFromBvh(values);
    }
}
