using System.Buffers.Binary;
using System.Text;
using NeuronMocap.Protocol;
using NeuronMocap.Server.Broadcasting;
using NeuronMocap.Server.Sources;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Clients;

// What the command channel knows of a broadcast (protocol.md section 6). ZeroOut is told an avatar, and says whether there is one. Any thread.
internal sealed class CommandAnswers(FramePlan plan, double rate, Func<int, bool> zeroOut, Action zeroOutAll)
{
    // Zero-out: 1, or 0 for an avatar that there is not. Else the answer, and nothing where there is none.
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

    // Appendix B goes on to the first lines of the motion; of a live stream there are no rows.
    private string GetHeader(MotionSource source)
    {
        double frameRate = double.IsPositiveInfinity(rate) ? source.FrameRate : rate;
        return SourceBody.GetHierarchy(source, plan.Order, plan.Layout)
            + FormattableString.Invariant($"MOTION\r\nFrames: 0\r\nFrame Time: {1 / frameRate:0.000000}\r\n");
    }
}
