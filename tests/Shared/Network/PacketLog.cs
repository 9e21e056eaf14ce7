using NeuronMocap.Protocol;

namespace NeuronMocap.Tests.Network;

// Receives packets like the receive path, and keeps copies.
internal sealed class PacketLog : IPacketReceiver
{
    public List<(PacketKind Kind, byte[] Bytes, int Sender)> Packets { get; } = [];

    public List<int> Origins { get; } = [];

    public int Skipped { get; private set; }

    /// <summary>The number of bytes of the text stream: in lines and after them.</summary>
    public int Text { get; private set; }

    public List<SkipReason> Reasons { get; } = [];

    public void OnPacket(in ReceivedPacket packet)
    {
        Packets.Add((packet.Kind, packet.Bytes.ToArray(), packet.Sender));
        Origins.Add(packet.Origin);
    }

    public void OnText(ReadOnlySpan<byte> bytes, PacketKind kind) => Text += bytes.Length;

    public void OnSkipped(ReadOnlySpan<byte> bytes, SkipReason reason)
    {
        Skipped += bytes.Length;
        Reasons.Add(reason);
    }
}
