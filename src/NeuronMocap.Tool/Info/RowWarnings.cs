using NeuronMocap.Bvh;
using NeuronMocap.Tool.Terminal;

namespace NeuronMocap.Tool.Info;

/// <summary>Describes the findings of a <see cref="RowScan"/>.</summary>
internal static class RowWarnings
{
    private const float RemarkableStep = 45;
    private const int MaxListed = 4;

    public static void Add(InfoSection section, RowScan scan, double frameRate, int columns)
    {
        if (scan.NotNumbers > 0)
            section.Remark("notNumbers", Quantity.Format($"{Quantity.Count(scan.NotNumbers, "value is not a finite number", "values are not finite numbers")}, the first in frame {scan.FirstNotNumber}"));
        if (scan.StartsAtRest)
            section.Remark("restPose", "the first frame is the rest pose, a T-pose, and the next one jumps: leave it out if you measure the motion");
        if (scan.Flips > 0)
        {
            (BvhJoint Joint, int Count)[] joints = [.. scan.FlippingJoints];
            string named = string.Join(", ", joints.Take(MaxListed).Select(static pair => Quantity.Format($"{pair.Joint.Name} {pair.Count}")));
            section.Remark(
                "flips",
                (scan.Flips == 1 ? "once" : Quantity.Format($"{scan.Flips:#,0} times"))
                    + Quantity.Format($" the angles of a joint jump while it hardly turns ({named}{(joints.Length > MaxListed ? ", …" : string.Empty)}), ")
                    + Quantity.Format($"first at {scan.FirstFlip / frameRate:0.00} s: compare and interpolate them as quaternions"));
        }

        if (scan.LargestStep is { Degrees: > RemarkableStep, Joint: { } joint } && !(scan.StartsAtRest && scan.LargestStep.Frame == 1))
        {
            section.Remark(
                "jump",
                Quantity.Format($"{joint.Name} turns by {scan.LargestStep.Degrees:0} degrees in one frame, at {scan.LargestStep.Frame / frameRate:0.00} s"));
        }

        if (scan.ConstantColumns > 0 && scan.ConstantColumns < columns)
            section.Remark("constantColumns", $"{scan.ConstantColumns} of the {columns} values never {Quantity.Noun(scan.ConstantColumns, "changes", "change")}");
        else if (scan.ConstantColumns == columns)
            section.Remark("constantColumns", "nothing moves: no value changes from one frame to the next");
    }
}
