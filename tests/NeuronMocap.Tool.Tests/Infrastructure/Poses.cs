using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.Tests.Infrastructure;

/// <summary>Frames of the default body in its T-pose.</summary>
internal static class Poses
{
    public static MotionFrame Upright(float x = 0, uint index = 0, float height = 0, int? avatar = null)
    {
        float[] values = new float[180];
        (values[0], values[1]) = (x, DefaultOffsets.Get(Bone.Hips).Y + height);
        return new MotionFrame(new MotionHeader { AvatarIndex = avatar ?? 0, AvatarName = new AvatarName(avatar is null ? "Char00" : $"Actor{avatar}"), FrameIndex = index }, values);
    }
}
