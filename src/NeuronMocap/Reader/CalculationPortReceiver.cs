using NeuronMocap.Protocol;
using NeuronMocap.Transport;

namespace NeuronMocap.Reader;

// Handles the packets of the calculation port until they join the path of the first connection. Called by the receive loop of its own link.
internal sealed class CalculationPortReceiver(ReceivePipeline pipeline, StreamRecognizer recognizer, LinkActivity activity, StreamTap tap) : IPacketReceiver, ILinkListener
{
    public StreamTap? Tap => tap;

    public void OnLinkOpened()
    {
        recognizer.Reset();
        pipeline.OnCalculationLinkOpened();
    }

    public void OnLinkClosed()
    {
    }

    public void OnPacket(in ReceivedPacket packet)
    {
        bool isNews = packet.IsFrame && recognizer.OnFrame(packet);
        activity.BeginDelivery(packet);
        try
        {
            if (isNews)
                activity.Redescribe(packet.Timestamp);

            pipeline.DeliverInTurn(packet);
        }
        finally
        {
            activity.EndDelivery();
        }
    }

    public void OnText(ReadOnlySpan<byte> bytes, PacketKind kind) => pipeline.CountText(bytes.Length);

    public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason)
    {
        pipeline.CountSkipped(bytes.Length, reason);
        activity.OnSkipped(bytes, reason);
    }
}
