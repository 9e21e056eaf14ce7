#nullable enable

namespace NeuronMocap.Unity.EditorTools
{
    // What a vendor's component connects to. Components with equal values share a source.
    internal sealed record SourceAddress
    {
        public SourceAddress(string address, int port, TransportKind transport, SkeletonVariantSetting variant)
        {
            // Over UDP, the computer receives on a port of its own.
            Address = transport == TransportKind.Udp ? string.Empty : address;
            Port = port;
            Transport = transport;
            Variant = variant;
        }

        public string Address { get; }

        public int Port { get; }

        public TransportKind Transport { get; }

        public SkeletonVariantSetting Variant { get; }

        public static SourceAddress? Of(MocapSource source) => source.Kind == SourceKind.Network
            ? new SourceAddress(source.Address, source.Port, source.Transport, source.SkeletonVariant)
            : null;

        public void CopyTo(MocapSource source)
        {
            source.Kind = SourceKind.Network;
            source.Port = Port;
            source.Transport = Transport;
            source.SkeletonVariant = Variant;
            if (Address.Length > 0)
                source.Address = Address;
        }

        public override string ToString() =>
            (Transport == TransportKind.Udp ? $"UDP port {Port}" : $"{Address}:{Port}") + (Variant == SkeletonVariantSetting.Auto ? string.Empty : $" ({Variant})");
    }
}
