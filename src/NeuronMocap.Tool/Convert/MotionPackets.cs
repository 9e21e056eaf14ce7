using NeuronMocap.Protocol;
using NeuronMocap.Server;
using NeuronMocap.Skeleton;

namespace NeuronMocap.Tool.Convert;

/// <summary>Converts a take to the motion packets that Axis Neuron would broadcast.</summary>
internal static class MotionPackets
{
    public static void Write(
        MotionSource take,
        ChannelLayout layout,
        RotationOrder order,
        AvatarName name,
        IPacketSink sink,
        IProgress<double> progress,
        CancellationToken cancellationToken)
    {
        long count = take.FrameCount!.Value;
        float[] values = new float[layout.ValueCount];
        var header = new MotionHeader
        {
            ValueCount = values.Length,
            HasDisplacement = layout.HasDisplacement,
            HasReference = layout.HasReference,
            AvatarName = name,
        };
        byte[] packet = new byte[header.PacketSize];
        for (long frame = 0; frame < count; frame++)
        {
            cancellationToken.ThrowIfCancellationRequested();
            take.WriteValues(frame, layout, order, values);
            int length = PacketEncoder.WriteMotion(packet, header with { FrameIndex = (uint)frame }, values);
            sink.Write(FrameTimes.Of(frame, take.FrameRate), packet.AsSpan(0, length));
            progress.Report((double)frame / count);
        }
    }
}

/// <summary>Computes when frames are due.</summary>
internal static class FrameTimes
{
    public static TimeSpan Of(long frame, double rate) => TimeSpan.FromTicks((long)Math.Round(frame * (TimeSpan.TicksPerSecond / rate)));
}
