using NeuronMocap.Protocol;
using NeuronMocap.Recording;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.Tests.Files;

/// <summary>A recording of two computers that send over UDP. Both number their frames alike, and both have an avatar 0 unless a test says otherwise.</summary>
internal static class TwoSenders
{
    public const int Frames = 60;

    /// <summary>Where the hips of the second sender's avatar stay along X, in centimetres. Those of the first stay at 0.</summary>
    public const float SecondX = 300;

    private static readonly string[] Names = ["Anna", "Ben"];

    public static void Record(string path, int firstAvatar = 0)
    {
        using RecordingWriter writer = RecordingWriter.Create(path, RecordingMetadata.Empty.With(RecordingMetadata.RotationOrderKey, "YXZ"));
        writer.OpenConnection(TimeSpan.Zero, new RecordedConnection(0, TransportKind.Udp, "0.0.0.0:7012", string.Empty));
        for (int sender = 0; sender < Names.Length; sender++)
            writer.AddSender(TimeSpan.Zero, 0, sender, $"192.168.1.2{sender}:7001");

        for (int frame = 0; frame < Frames; frame++)
        {
            writer.WriteBytes(TimeSpan.FromSeconds(frame / 60.0), 0, Packet(0, firstAvatar, frame, 0), sender: 0);
            writer.WriteBytes(TimeSpan.FromSeconds((frame / 60.0) + 0.002), 0, Packet(1, 0, frame, SecondX), sender: 1);
        }
    }

    private static byte[] Packet(int sender, int avatar, int frame, float x)
    {
        var layout = new ChannelLayout(hasDisplacement: true, hasReference: false);
        float[] values = new float[layout.ValueCount];
        new SyntheticSource(60).WriteValues(frame, layout, RotationOrder.YXZ, values);
        values[0] = x;
        var header = new MotionHeader { AvatarName = new AvatarName(Names[sender]), AvatarIndex = avatar, FrameIndex = (uint)frame, HasDisplacement = true, ValueCount = values.Length };
        byte[] packet = new byte[header.PacketSize];
        PacketEncoder.WriteMotion(packet, header, values);
        return packet;
    }
}
