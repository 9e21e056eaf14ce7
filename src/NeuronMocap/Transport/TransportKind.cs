namespace NeuronMocap;

/// <summary>How the server sends: the "Protocol" of Axis Neuron's broadcasting settings.</summary>
public enum TransportKind
{
    /// <summary>The reader connects to the server, which sends to every client.</summary>
    Tcp,

    /// <summary>The server sends datagrams to this computer; the reader binds the port that they are sent to.</summary>
    Udp,
}
