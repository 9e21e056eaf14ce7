using NeuronMocap.Protocol;

namespace NeuronMocap.Recording;

// Stands between the parsers and the reader. It counts frames, and holds back data that is only read to find a position.
internal sealed class PlaybackReceiver : IPacketReceiver
{
    public IPacketReceiver? Target { get; set; }

    public bool IsMuted { get; set; }

    // The time of the next packets.
    public TimeSpan Time { get; set; }

    public long Frames { get; private set; }

    // The time of the latest frame, and the number of frames with that time, including that frame.
    public TimeSpan FrameTime { get; private set; }

    public int FramesOfTime { get; private set; }

    // Sets the time as if it had no frames yet.
    public void Place(TimeSpan time)
    {
        FrameTime = time;
        FramesOfTime = 0;
    }

    public void OnPacket(in ReceivedPacket packet)
    {
        if (packet.IsFrame)
        {
            Frames++;
            FramesOfTime = Time == FrameTime ? FramesOfTime + 1 : 1;
            FrameTime = Time;
        }

        if (!IsMuted)
            Target!.OnPacket(packet);
    }

    public void OnText(ReadOnlySpan<byte> bytes, PacketKind kind)
    {
        if (!IsMuted)
            Target!.OnText(bytes, kind);
    }

    public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason)
    {
        if (!IsMuted)
            Target!.OnSkipped(bytes, reason);
    }
}
