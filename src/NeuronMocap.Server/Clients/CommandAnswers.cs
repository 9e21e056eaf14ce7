using System.Buffers.Binary;
using System.Text;
using NeuronMocap.Protocol;
using NeuronMocap.Server.Sources;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Server.Clients;

// What the command channel knows of a broadcast (protocol.md section 6). Any thread.
internal sealed class CommandAnswers(Broadcaster broadcaster)
{
    // Zero-out: 1, or 0 for an avatar that there is not. Else the answer, and nothing where there is none.
    public byte[] GetPayload(int commandId, ReadOnlySpan<byte> parameters)
    {
        int avatar = parameters.Length >= sizeof(int) ? BinaryPrimitives.ReadInt32LittleEndian(parameters) : -1;
        switch ((CommandChannelId)commandId)
        {
            case CommandChannelId.ZeroOut:
                return Encode(broadcaster.ZeroOut(avatar) ? 1 : 0);
            case CommandChannelId.ZeroOutAll:
                broadcaster.ZeroOutAll();
                return Encode(1);
            case CommandChannelId.RotationOrder:
                return Encode((int)broadcaster.Plan!.Order);
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

    private MotionSource? Find(int avatar) => (uint)avatar < (uint)broadcaster.Plan!.AvatarCount ? broadcaster.Plan!.Sources[avatar] : null;

    // Appendix B goes on to the first lines of the motion; of a live stream there are no rows.
    private string GetHeader(MotionSource source)
    {
        double rate = double.IsPositiveInfinity(broadcaster.Rate) ? source.FrameRate : broadcaster.Rate;
        return SourceBody.GetHierarchy(source, broadcaster.Plan!.Order, broadcaster.Layout)
            + FormattableString.Invariant($"MOTION\r\nFrames: 0\r\nFrame Time: {1 / rate:0.000000}\r\n");
    }
}
