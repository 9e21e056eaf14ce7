using NeuronMocap.Protocol;

namespace NeuronMocap.Recording;

// Between the parsers and the reader: counts frames, and keeps back what is read only to find a place.
internal sealed class PlaybackReceiver : IPacketReceiver
{
    public IPacketReceiver? Target { get; set; }

    public bool IsMuted { get; set; }

    // Of what comes next.
    public TimeSpan Time { get; set; }

    public long Frames { get; private set; }

    // The newest frame, and how many of its time there were, it included.
    public TimeSpan FrameTime { get; private set; }

    public int FramesOfTime { get; private set; }

    // As if no frame of this time had been there yet.
    public void Place(TimeSpan time)
    {
        FrameTime = time;
        FramesOfTime = 0;
    }

    public StreamTap? Tap => null;

    public void OnLinkOpened()
    {
    }

    public void OnLinkClosed()
    {
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

    public void OnText(ReadOnlySpan<byte> bytes)
    {
        if (!IsMuted)
            Target!.OnText(bytes);
    }

    public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason)
    {
        if (!IsMuted)
            Target!.OnSkipped(bytes, reason);
    }
}
