using NeuronMocap.Compatibility.Callbacks;

namespace NeuronMocap.Compatibility.Sockets;

// A UDP service. As in the vendor's library, it shares its port and calls no status callback.
internal sealed class UdpDataSocket(IVendorCallbacks callbacks, int port)
    : DataSocket(callbacks, new NeuronReaderOptions { Transport = TransportKind.Udp, Port = port, SharePort = true })
{
    private readonly int _port = port;

    // Any number of services may receive on a port.
    public override bool IsTo(VendorSocket other) => false;

    protected override bool TryOpen()
    {
        if (StartReader() is int error)
        {
            LastError.Set(FormattableString.Invariant($"Failed to bind UDP service to port {_port}."), error);
            return false;
        }

        SetOpen();
        return true;
    }

    protected override void OnEnded(ConnectionReason reason) => LastError.Set("Failed to read data.", SystemError.CodeOf(reason));
}
