namespace NeuronMocap.Recording;

/// <summary>Describes a connection, or a bound UDP port, in a recording.</summary>
/// <param name="Number">The number in the recording, from 0. It is unique.</param>
/// <param name="Transport">The transport of the bytes.</param>
/// <param name="Local">The end point of this computer, such as "192.168.1.5:50412"; empty when unknown.</param>
/// <param name="Remote">The end point of the server; empty when unknown, and over UDP, where every sender has its own.</param>
public sealed record RecordedConnection(int Number, TransportKind Transport, string Local, string Remote)
{
    /// <summary>
    /// Whether the connection was already open. Its earlier bytes are then not in the recording, or they are in an earlier file or before the
    /// position where reading began.
    /// </summary>
    public bool WasOpen { get; init; }

    /// <summary>
    /// Whether this is the additional connection of <see cref="NeuronReaderOptions.CalculationPort"/>. Only its calculation data is used.
    /// </summary>
    public bool IsCalculation { get; init; }
}
