namespace NeuronMocap;

/// <summary>The way in which the server sends: the "Protocol" in Axis Neuron's broadcasting settings.</summary>
public enum TransportKind
{
    /// <summary>The reader connects to the server, which sends to every client.</summary>
    Tcp,

    /// <summary>The server sends datagrams to this computer; the reader binds the destination port.</summary>
    Udp,
}
