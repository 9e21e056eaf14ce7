using System.Buffers.Binary;
using System.Text;
using NeuronMocap.Protocol;
using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Server.Sources;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Clients;

// Answers of the command channel about a broadcast (protocol.md section 6). ZeroOut returns whether the avatar exists. Thread-safe.
internal sealed class CommandAnswers(FramePlan plan, double rate, Func<int, bool> zeroOut, Action zeroOutAll)
{
    // For a zero-out: 1, or 0 if the avatar does not exist. For other commands the answer, or nothing if there is no answer.
    public byte[] GetPayload(int commandId, ReadOnlySpan<byte> parameters)
    {
        int avatar = parameters.Length >= sizeof(int) ? BinaryPrimitives.ReadInt32LittleEndian(parameters) : -1;
        switch ((CommandChannelId)commandId)
        {
            case CommandChannelId.ZeroOut:
                return Encode(zeroOut(avatar) ? 1 : 0);
            case CommandChannelId.ZeroOutAll:
                zeroOutAll();
                return Encode(1);
            case CommandChannelId.RotationOrder:
                return Encode((int)plan.Order);
            case CommandChannelId.BoneDimensions when Find(avatar) is { } source:
                return GetDimensions(source);
            case CommandChannelId.BvhHeader when Find(avatar) is { } source:
                return Encoding.ASCII.GetBytes(GetHeader(source));
            default:
                return [];
        }
    }

    private static byte[] Encode(int value)
    {
        byte[] bytes = new byte[sizeof(int)];
        BinaryPrimitives.WriteInt32LittleEndian(bytes, value);
        return bytes;
    }

    private static byte[] GetDimensions(MotionSource source)
    {
        byte[] bytes = new byte[BoneDimensions.Size];
        SourceBody.Measure(source).Write(bytes);
        return bytes;
    }

    private MotionSource? Find(int avatar) => (uint)avatar < (uint)plan.AvatarCount ? plan.Sources[avatar] : null;

    // The header in Appendix B includes the first lines of the motion. A live stream has no rows.
    private string GetHeader(MotionSource source)
    {
        double frameRate = double.IsPositiveInfinity(rate) ? source.FrameRate : rate;
        return SourceBody.GetHierarchy(source, plan.Order, plan.Layout)
            + FormattableString.Invariant($"MOTION\r\nFrames: 0\r\nFrame Time: {1 / frameRate:0.000000}\r\n");
    }
}
