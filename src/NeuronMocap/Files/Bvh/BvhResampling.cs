using System.Numerics;

namespace NeuronMocap.Bvh;

// Converts takes to another frame rate.
internal static class BvhResampling
{
    public static BvhDocument Resample(BvhDocument document, BvhFrameTime frameTime)
    {
        ArgumentNullException.ThrowIfNull(document);
        if (frameTime == default)
            throw new ArgumentException("The frame time must be more than 0 s.", nameof(frameTime));
        if (frameTime == document.FrameTime || document.FrameCount < 2)
            return new BvhDocument(document.Hierarchy, frameTime, document.CopyValues()) { TextFormat = document.TextFormat };

        // Frame n of the new take is frame n * step / unit of the old one. Rates are 64-bit fractions, so their products need integers of any size.
        BigInteger step = (BigInteger)frameTime.Numerator * document.FrameTime.Denominator;
        BigInteger unit = (BigInteger)frameTime.Denominator * document.FrameTime.Numerator;
        BigInteger last = (document.FrameCount - 1) * unit;
        BigInteger count = ((last + step - 1) / step) + 1;
        if (count * document.ChannelCount > int.MaxValue)
            throw new ArgumentException($"The result has {count} frames, more than a document can have.", nameof(frameTime));

        float[] values = new float[(int)count * document.ChannelCount];
        BvhJointValues[] joints = [.. document.Hierarchy.GetJointValues().Where(static joint => joint.TurnsFreely)];
        for (int frame = 0; frame < (int)count; frame++)
        {
            BigInteger time = BigInteger.Min(frame * step, last);
            var before = (int)BigInteger.DivRem(time, unit, out BigInteger rest);
            Span<float> row = values.AsSpan(frame * document.ChannelCount, document.ChannelCount);
            if (rest.IsZero)
                document.GetValues(before).CopyTo(row);
            else
                Interpolate(document, joints, before, (double)rest / (double)unit, row);
        }

        // The old text may stand for the new rate, as 0.008 does for 120 Hz. Other programs would read it literally.
        return new BvhDocument(document.Hierarchy, frameTime, values) { TextFormat = document.TextFormat with { FrameTimeText = null } };
    }

    private static void Interpolate(BvhDocument document, BvhJointValues[] turning, int frame, double part, Span<float> row)
    {
        ReadOnlySpan<float> from = document.GetValues(frame);
        ReadOnlySpan<float> to = document.GetValues(frame + 1);
        foreach (BvhJoint joint in document.Joints)
        {
            for (int i = 0; i < joint.Channels.Count; i++)
            {
                int column = joint.FirstChannel + i;
                double way = (double)to[column] - from[column];
                if (joint.Channels[i].IsRotation())
                    way -= 360 * Math.Round(way / 360);

                row[column] = (float)(from[column] + (part * way));
            }
        }

        // One or two angles alone do not define the path between two rotations. The angles of such joints stay interpolated independently.
        foreach (BvhJointValues joint in turning)
        {
            BvhRotation rotation = BvhRotation.Slerp(joint.GetRotation(from), joint.GetRotation(to), part);
            joint.SetRotation(row, rotation, joint.GetAngles(part < 0.5 ? from : to));
        }
    }
}
