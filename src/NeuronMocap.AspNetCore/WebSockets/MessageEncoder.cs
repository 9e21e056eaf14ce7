using System.Net.WebSockets;
using NeuronMocap.Json;
using NeuronMocap.Protocol;

namespace NeuronMocap.AspNetCore;

/// <summary>Writes frames as messages of each form, once for all clients. Not thread-safe.</summary>
internal sealed class MessageEncoder
{
    private const int VersionOffset = 2;

    // As many as a reader counts. Skeletons of further avatars are made again.
    private const int MaxAvatars = 1024;

    private readonly MessagePool _pool = new();
    private readonly FrameLines _lines = new(new JsonClock());
    private readonly SkeletonChanges _changes = new();
    private readonly Dictionary<(int Sender, int Avatar), byte[]> _skeletons = [];

    /// <summary>Makes a message, which the caller releases. Null if the form has none for this frame.</summary>
    public MotionMessage? Encode(AvatarFrame frame, WebSocketForm form)
    {
        MotionMessage message = _pool.Rent();
        message.Begin(frame, form == WebSocketForm.Json ? WebSocketMessageType.Text : WebSocketMessageType.Binary);
        bool isWritten = form switch
        {
            WebSocketForm.Packet => WritePacket(frame, message),
            WebSocketForm.Pose => frame is MotionFrame motion && WritePose(motion, message),
            _ => WriteJson(frame, message),
        };
        if (isWritten)
            return message;

        message.Release();
        return null;
    }

    private static bool WritePacket(AvatarFrame frame, MotionMessage message)
    {
        ReadOnlySpan<byte> packet = frame.Packet;
        Span<byte> bytes = message.Reserve(packet.Length);
        packet.CopyTo(bytes);

        // A packet that was made of a line of text has no version and no second token, so receivers would not recognize it.
        if (bytes[ProtocolConstants.Token2Offset] == 0)
        {
            PacketTokens.Write(bytes, message.Key.Kind);
            (message.Key.Kind == PacketKind.Motion ? DataVersion.Old : DataVersion.Calculation).Write(bytes[VersionOffset..]);
        }

        return true;
    }

    private static bool WritePose(MotionFrame frame, MotionMessage message)
    {
        bool isPose = CompactPose.TryEncode(frame, message.Reserve(CompactPose.MaxSize), out int length);
        message.Trim(length);
        return isPose;
    }

    private bool WriteJson(AvatarFrame frame, MotionMessage message)
    {
        message.Skeleton = frame is MotionFrame motion ? FindSkeleton(motion) : null;
        ReadOnlySpan<byte> line = WithoutLineEnd(frame switch
        {
            MotionFrame each => _lines.Frame(each),
            CalculationFrame each => _lines.Calculation(each),
            _ => _lines.StudioCalculation((StudioCalculationFrame)frame),
        });
        line.CopyTo(message.Reserve(line.Length));
        return true;
    }

    private byte[] FindSkeleton(MotionFrame frame)
    {
        (int, int) key = (frame.Sender, frame.AvatarIndex);
        if (!_changes.IsNew(frame) && _skeletons.TryGetValue(key, out byte[]? known))
            return known;

        if (_skeletons.Count >= MaxAvatars)
            _skeletons.Clear();

        return _skeletons[key] = WithoutLineEnd(_lines.Skeleton(frame)).ToArray();
    }

    private static ReadOnlySpan<byte> WithoutLineEnd(ReadOnlySpan<byte> line) => line[..^1];
}
