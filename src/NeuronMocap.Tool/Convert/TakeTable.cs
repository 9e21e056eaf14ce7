using NeuronMocap.Csv;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;
using NeuronMocap.Tool.Files;

namespace NeuronMocap.Tool.Convert;

/// <summary>Writes a take at an even rate as a table of poses.</summary>
internal static class TakeTable
{
    public static void Write(
        FileSettings settings, InputTake take, MotionSource motion, string path, IProgress<double> progress, CancellationToken cancellationToken)
    {
        int avatar = take.Motion is RecordingSource recording ? recording.AvatarIndex : settings.Avatar ?? 0;
        using var writer = new PoseCsvWriter(path, new PoseCsvOptions
        {
            UpAxis = settings.UpAxis ?? default,
            Unit = settings.Unit ?? default,
            Variant = motion.Variant,
            Source = settings.SourceName,
            RotationOrder = take.Calculation is null ? take.Order : null,
            FrameRate = motion.FrameRate,
            AvatarNames = new Dictionary<int, string> { [avatar] = take.AvatarName },
        });

        var pose = new BoneTransform[BoneHierarchy.BoneCount];
        long count = motion.FrameCount!.Value;
        for (long frame = 0; frame < count; frame++)
        {
            cancellationToken.ThrowIfCancellationRequested();
            motion.GetPose(frame, pose);
            ForwardKinematics.ToWorld(pose, pose, motion.Variant);
            writer.WriteRow(FrameTimes.Of(frame, motion.FrameRate), pose, avatar, frame);
            progress.Report((double)frame / count);
        }
    }
}
