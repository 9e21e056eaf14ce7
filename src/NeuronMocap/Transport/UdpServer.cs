namespace NeuronMocap.Transport;

// The sources of motion and calculation data with one address and one sender number. They use the same port, or one port each.
internal sealed class UdpServer(int number, HostKey host)
{
    private readonly UdpSender?[] _senders = new UdpSender?[2];

    public int Number => number;

    public HostKey Host => host;

    // How often a sender was replaced.
    public int Run { get; set; }

    public bool IsEmpty => _senders[0] is null && _senders[1] is null;

    public UdpSender? Any => _senders[0] ?? _senders[1];

    public UdpSender? this[bool isCalculation]
    {
        get => _senders[isCalculation ? 1 : 0];
        set => _senders[isCalculation ? 1 : 0] = value;
    }

    public void Remove(UdpSender sender)
    {
        for (int i = 0; i < _senders.Length; i++)
        {
            if (_senders[i] == sender)
                _senders[i] = null;
        }

        sender.Server = null;
    }
}
